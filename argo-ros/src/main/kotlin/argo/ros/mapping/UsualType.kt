package argo.ros.mapping

/**
 * A message type whose fields ARGO knows. Rules for the type have a short form. In the short form, a name that is no field is an atom.
 *
 * @property percept the default arguments of a percept
 * @property command the fields for a command's arguments, in order; empty if there is no short form
 */
internal class UsualType(val fields: Set<String>, val percept: List<String>, val command: List<String>) {
    companion object {
        private val DATA = UsualType(setOf("data"), listOf("data"), listOf("data"))
        private val POSE = listOf("position.x", "position.y", "yaw(orientation)")

        private val TYPES: Map<String, UsualType> = listOf("Bool", "String", "Int32", "Int64", "Float32", "Float64")
            .associate { "std_msgs/$it" to DATA } + mapOf(
            "sensor_msgs/Range" to of("header radiation_type field_of_view min_range max_range range variance", "range"),
            "sensor_msgs/LaserScan" to of(
                "header angle_min angle_max angle_increment time_increment scan_time range_min range_max ranges intensities",
                "min(ranges)",
            ),
            "sensor_msgs/BatteryState" to of(
                "header voltage temperature current charge capacity design_capacity percentage power_supply_status power_supply_health " +
                    "power_supply_technology present cell_voltage cell_temperature location serial_number",
                "percentage",
            ),
            "sensor_msgs/Imu" to of(
                "header orientation orientation_covariance angular_velocity angular_velocity_covariance linear_acceleration " +
                    "linear_acceleration_covariance",
                "yaw(orientation)", "angular_velocity.z",
            ),
            "sensor_msgs/Temperature" to of("header temperature variance", "temperature"),
            "nav_msgs/Odometry" to of("header child_frame_id pose twist", *POSE.map { inPose("pose.pose", it) }.toTypedArray()),
            "geometry_msgs/PoseStamped" to of("header pose", *POSE.map { inPose("pose", it) }.toTypedArray()),
            "geometry_msgs/Pose" to of("position orientation", *POSE.toTypedArray()),
            "geometry_msgs/Twist" to
                UsualType(setOf("linear", "angular"), listOf("linear.x", "angular.z"), listOf("linear.x", "angular.z")),
            "turtlesim/Pose" to of("x y theta linear_velocity angular_velocity", "x", "y", "theta"),
        )

        private fun of(fields: String, vararg percept: String) = UsualType(fields.split(' ').toSet(), percept.asList(), emptyList())

        private fun inPose(path: String, field: String) =
            if (field.startsWith("yaw(")) "yaw($path.orientation)" else "$path.$field"

        /**
         * Returns the usual type named [type], or null if there is none. Accepts ROS 1 and ROS 2 names, such as `sensor_msgs/msg/Range`.
         */
        fun of(type: String): UsualType? = TYPES[type.replace("/msg/", "/")]

        val names: Set<String> get() = TYPES.keys

        /** The type for the pose of one frame in another. */
        val FRAME_POSE = UsualType(setOf("x", "y", "z", "yaw", "rotation"), emptyList(), emptyList())
    }
}
