package argo.ros.mapping

/**
 * The credentials of a client for a bridge, or for a server in front of it.
 *
 * @property token sent as `Authorization: Bearer …`, or null if there is none
 * @property secret the secret for the parameter `authenticate` of `rosbridge_server` in ROS 1, or null if there is none
 */
internal class Credentials(val token: String? = null, val secret: String? = null)
