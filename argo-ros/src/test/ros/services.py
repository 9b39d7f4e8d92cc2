"""Prints the names of the services of a ROS 1 graph in one line."""

import rosservice

print(" ".join(rosservice.get_service_list()))
