// A parameter that is read into the variable of another one, which nothing reads.
//
// expect: 3 = count : { read_for_another(_, _, _, _) }
// expect: read_for_another(_, "position/x", "y", "position/y")
// expect: read_for_another(_, "position/x", "z", "position/z")
// expect: read_for_another(_, "gain_p", "i", "gain_i")
#include <ros/ros.h>

class Sensor {
public:
  Sensor() : pnh_("~") {
    double x, y, z;
    pnh_.param("position/x", x, 0.0);
    pnh_.param("position/x", y, 0.0);
    pnh_.param("position/x", z, 0.0);
    pnh_.param("gain_p", p_, 1.0);
    pnh_.param("gain_p", i_, 1.0);
    // another one reads it
    double width, height;
    pnh_.param("size/width", width, 1.0);
    pnh_.param("size/width", height, 1.0);
    pnh_.param("size/height", height, height);
    // no variable of its own name
    double first, second;
    pnh_.param("rate", first, 1.0);
    pnh_.param("rate", second, 1.0);
    // of other handles
    ros::NodeHandle left("~left"), right("~right");
    double speed, limit;
    left.param("max/speed", speed, 1.0);
    right.param("max/speed", limit, 1.0);
    pnh_.setParam("sum", x + y + z + p_ + i_ + width + height + first + second + speed + limit);
  }

private:
  ros::NodeHandle pnh_;
  double p_, i_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "sensor");
  Sensor sensor;
  ros::spin();
}
