package argo.ros.mapping

/**
 * The credentials of a client, for a bridge or a server in front of the bridge.
 *
 * @property token sent as `Authorization: Bearer …`; null: none
 * @property secret shared with the bridge, as with the parameter `authenticate` of `rosbridge_server` in ROS 1; null: none
 */
internal class Credentials(val token: String? = null, val secret: String? = null)
