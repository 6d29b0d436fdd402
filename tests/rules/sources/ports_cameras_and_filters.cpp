// Ports of cameras, filters, options and handles: names with parts that parameters tell, types from templates, arguments and callbacks.
//
// expect: publisher image sensor_msgs/Image queue=1 latched=false via=image_transport
// expect: publisher camera_info sensor_msgs/CameraInfo queue=1 via=image_transport
// expect: publisher ~raw sensor_msgs/Image via=image_transport
// expect: publisher ~camera_info sensor_msgs/CameraInfo via=image_transport
// expect: publisher left/image sensor_msgs/Image via=image_transport
// expect: publisher left/camera_info sensor_msgs/CameraInfo via=image_transport
// expect: subscriber /front/image sensor_msgs/Image callback=onCamera via=image_transport
// expect: subscriber /front/camera_info sensor_msgs/CameraInfo via=image_transport
// expect: publisher ? std_msgs/Int32 from_param=~topic unknown="named by parameter ~topic"
// expect: publisher ? std_msgs/Int32 unknown="not a constant: argv[1]"
// expect: publisher ?/tail std_msgs/Int32 unknown="not a constant: std::string(argv[2]) + \"/tail\""
// expect: publisher /status std_msgs/Int32 latched=true
// expect: publisher /plain std_msgs/Int32 latched=false
// expect: publisher /options std_msgs/String queue=5
// expect: publisher /initialised std_msgs/String queue=2
// expect: subscriber /assigned std_msgs/Int32 queue=3 callback=onChain
// expect: subscriber /bound std_msgs/Int32 callback=onBound
// expect: subscriber /scan sensor_msgs/LaserScan queue=7 callback=onScan via=message_filters
// expect: subscriber /first std_msgs/Int32 callback=onBoth via=message_filters
// expect: subscriber /second std_msgs/String callback=onBoth via=message_filters
// expect: subscriber /chain std_msgs/Int32 callback=onChain via=message_filters
// expect: subscriber /unheard std_msgs/Int32 callback= via=message_filters
// expect: service_client /add std_srvs/Empty
// expect: service_client reset std_srvs/Empty
// expect: publisher /ns/inner std_msgs/Int32
// expect-only: publisher
// expect-only: subscriber
// expect-only: service_client
// expect: Count = count : { port_made_through(Port, Call) }, Count = 2
// expect: port_made_through([_, _, "/left_wheel"], C)
// expect: publisher /left_wheel std_msgs/Int32
// expect: publisher /right_wheel std_msgs/Int32
// expect: 2 = count : { bound_argument(_, _, _) }, 25 = count : { call_namespace(_, _, _, _) }
// expect: beside([_, "publisher", "camera_info"], [_, "publisher", "image"], "camera_info"), beside([_, "publisher", "~camera_info"], [_, "publisher", "~raw"], _)
// expect-not: port_quality([_, "subscriber", "/scan"], "reliability", _)
// expect: 25 = count : { port_quality_given(_, _, _) }, 2 = count : { synchronised(_, _) }
#include <image_transport/image_transport.h>
#include <message_filters/cache.h>
#include <message_filters/subscriber.h>
#include <message_filters/time_synchronizer.h>
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/LaserScan.h>
#include <std_msgs/Int32.h>
#include <std_msgs/String.h>
#include <std_srvs/Empty.h>
#include <string>

void onCamera(const sensor_msgs::ImageConstPtr&, const sensor_msgs::CameraInfoConstPtr&) {}
void onBound(const std_msgs::Int32ConstPtr&, const std_msgs::String&) {}
void onScan(const sensor_msgs::LaserScanConstPtr&) {}
void onBoth(const std_msgs::Int32ConstPtr&, const std_msgs::StringConstPtr&) {}
void onChain(const std_msgs::Int32ConstPtr&) {}

ros::Publisher wheel(ros::NodeHandle& nh, const std::string& side)
{
  return nh.advertise<std_msgs::Int32>("/" + side + "_wheel", 1);
}

// nobody calls it
void unused(ros::NodeHandle& nh)
{
  ros::Publisher pub = nh.advertise<std_msgs::Int32>("/unused", 1);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh, private_nh("~"), inner_nh("/ns");

  image_transport::ImageTransport transport(nh), private_transport(private_nh);
  image_transport::CameraPublisher camera_pub = transport.advertiseCamera("image", 1);
  image_transport::CameraPublisher private_pub = private_transport.advertiseCamera("raw", 1);
  image_transport::CameraPublisher left_pub = transport.advertiseCamera("left/image", 1);
  image_transport::CameraSubscriber camera_sub = transport.subscribeCamera("/front/image", 1, onCamera);

  std::string topic;
  private_nh.param<std::string>("topic", topic, "");
  ros::Publisher named_pub = nh.advertise<std_msgs::Int32>(topic, 1);
  ros::Publisher given_pub = nh.advertise<std_msgs::Int32>(argv[1], 1);
  ros::Publisher tail_pub = nh.advertise<std_msgs::Int32>(std::string(argv[2]) + "/tail", 1);
  ros::Publisher status_pub = nh.advertise<std_msgs::Int32>("/status", 1, 1);
  ros::Publisher plain_pub = nh.advertise<std_msgs::Int32>("/plain", 1, 0);
  ros::Publisher inner_pub = inner_nh.advertise<std_msgs::Int32>("inner", 1);
  ros::Publisher left = wheel(nh, "left"), right = wheel(nh, "right");

  ros::AdvertiseOptions options;
  options.topic = "/options";
  options.queue_size = 5;
  options.datatype = "std_msgs/String";
  if (options.queue_size == 9)
    options.latch = false;
  ros::Publisher options_pub = nh.advertise(options);
  ros::AdvertiseOptions initialised, unused_options;
  initialised.init<std_msgs::String>("/initialised", 2);
  unused_options.init<std_msgs::String>("/never_advertised", 2);
  ros::Publisher initialised_pub = nh.advertise(initialised);
  ros::SubscribeOptions assigned;
  assigned = ros::SubscribeOptions::create<std_msgs::Int32>("/assigned", 3, onChain, ros::VoidPtr(), nullptr);
  ros::Subscriber assigned_sub = nh.subscribe(assigned);

  std_msgs::String text;
  ros::Subscriber bound_sub = nh.subscribe<std_msgs::Int32>("/bound", 1, boost::bind(onBound, _1, text));

  message_filters::Subscriber<sensor_msgs::LaserScan> scan_sub(nh, "/scan", 7);
  scan_sub.registerCallback(onScan);
  message_filters::Subscriber<std_msgs::Int32> first_sub(nh, "/first", 1), chain_sub(nh, "/chain", 1), unheard_sub(nh, "/unheard", 1);
  message_filters::Subscriber<std_msgs::String> second_sub(nh, "/second", 1);
  message_filters::TimeSynchronizer<std_msgs::Int32, std_msgs::String> synchronizer(first_sub, second_sub, 10);
  synchronizer.registerCallback(onBoth);
  message_filters::Cache<std_msgs::Int32> cache(chain_sub, 5);
  cache.registerCallback(onChain);
  message_filters::Subscriber<std_msgs::Int32> none_sub(nh, "", 1);

  std_srvs::Empty request;
  ros::service::call("/add", request);
  ros::ServiceClient client = nh.serviceClient<std_srvs::Empty>("reset");
  ros::spin();
}
