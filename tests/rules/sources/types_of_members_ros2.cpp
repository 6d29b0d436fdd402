// The type of a port is a member of a class that another class gives a name: the message of a specification.
//
// expect: publisher map nav_msgs/OccupancyGrid queue=1
// expect: subscriber info nav_msgs/MapMetaData
#include <nav_msgs/msg/map_meta_data.hpp>
#include <nav_msgs/msg/occupancy_grid.hpp>
#include <rclcpp/rclcpp.hpp>

namespace specs
{
struct Map
{
  using Message = nav_msgs::msg::OccupancyGrid;
  static constexpr char name[] = "map";
};
struct Info
{
  using Message = nav_msgs::msg::MapMetaData;
  static constexpr char name[] = "info";
};
}  // namespace specs

template <typename T>
class Wrapper : public rclcpp::Node
{
public:
  using rclcpp::Node::Node;
  template <typename M>
  typename rclcpp::Publisher<M>::SharedPtr publisher(const std::string & name, const rclcpp::QoS & qos) { return create_publisher<M>(name, qos); }
};

class Loader : public Wrapper<int>
{
public:
  using Map = specs::Map;
  using Info = specs::Info;

  Loader() : Wrapper<int>("loader")
  {
    map_ = publisher<Map::Message>(Map::name, rclcpp::QoS{1});
    info_ = create_subscription<Info::Message>(Info::name, 1, [](Info::Message::ConstSharedPtr) {});
  }

private:
  rclcpp::Publisher<Map::Message>::SharedPtr map_;
  rclcpp::Subscription<Info::Message>::SharedPtr info_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Loader>());
}
