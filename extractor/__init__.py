"""From the sources of a ROS workspace to facts; no conclusion about ROS is drawn here."""
