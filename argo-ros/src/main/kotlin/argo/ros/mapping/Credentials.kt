package argo.ros.mapping

/**
 * What a bridge or a server in front of it may want to know of its clients.
 *
 * @property token shown as `Authorization: Bearer …`; null: none
 * @property secret known to the bridge too, which `rosbridge_server` of ROS 1 has with `authenticate`; null: none
 */
internal class Credentials(val token: String? = null, val secret: String? = null)
