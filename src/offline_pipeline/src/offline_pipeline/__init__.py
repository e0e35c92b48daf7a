"""From a sentence to what would run, in one process, without ROS."""
