template <typename First, typename Second, typename Names>
Pairing<First, Second, Names>::Pairing(const std::string& prefix)
{
  ros::NodeHandle nh;
  first_sub_ = nh.subscribe(prefix + "/first", 1, &Pairing::onFirst, this);
  second_sub_ = nh.subscribe(prefix + "/second", 1, &Pairing::onSecond, this);
  first_pub_ = nh.advertise<First>(Names::first, 4);
  second_pub_ = nh.advertise<Second>(Names::second(), 4);
}

template <typename First, typename Second, typename Names>
void Pairing<First, Second, Names>::onFirst(const typename First::ConstPtr& message)
{
  first_pub_.publish(message);
}

template <typename First, typename Second, typename Names>
void Pairing<First, Second, Names>::onSecond(const typename Second::ConstPtr& message)
{
  second_pub_.publish(message);
}

template <typename First, typename Second, typename Names>
void Pairing<First, Second, Names>::run()
{
  ros::spin();
}
