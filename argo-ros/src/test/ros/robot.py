"""A robot on a real ROS 1 graph, for tests and recorded transcripts.

    robot.py [HZ]

Publishes /count (std_msgs/Int32), /sonar (sensor_msgs/Range with a time stamp) and /scan (sensor_msgs/LaserScan with a NaN and an infinite
range) at HZ. The default of HZ is 20. Republishes each message of /cmd_vel on /driven. Serves /horn (std_srvs/Trigger), /lamp
(std_srvs/SetBool; switching off fails), /rest (std_srvs/Empty) and /camera (sensor_msgs/SetCameraInfo; the answer repeats the distortion
model). Serves the action /drive (actionlib/TestAction). A goal above 0 succeeds after as many tenths of a second. The feedback is half of
the goal. A goal below 0 is aborted, and 0 is rejected. Publishes cancelled goals on /cancelled (std_msgs/Int32). Counts the connections of
/cmd_vel, goals, cancellations, /driven, results and feedback, and publishes the smallest count on /clients (std_msgs/Int32). A client loses
messages that were sent before it connected.
"""

import sys
import threading
import time

import rospy
from actionlib import ActionServer
from actionlib.msg import TestAction, TestFeedback, TestResult
from geometry_msgs.msg import Twist
from sensor_msgs.msg import LaserScan, Range
from sensor_msgs.srv import SetCameraInfo, SetCameraInfoResponse
from std_msgs.msg import Int32
from std_srvs.srv import Empty, EmptyResponse, SetBool, SetBoolResponse, Trigger, TriggerResponse

goals = {}


def drive(handle):
    goal = handle.get_goal().goal
    if goal == 0:
        handle.set_rejected(None, "there is nowhere to go")
        return
    handle.set_accepted()
    cancelled = goals[handle.get_goal_id().id] = threading.Event()

    def arrive():
        handle.publish_feedback(TestFeedback(feedback=goal // 2))
        if cancelled.wait(abs(goal) / 10):
            handle.set_canceled(None, "it was cancelled")
            cancellations.publish(goal)
        elif goal < 0:
            handle.set_aborted(TestResult(result=goal), "a wall is in the way")
        else:
            handle.set_succeeded(TestResult(result=goal), "")

    threading.Thread(target=arrive, daemon=True).start()


def cancel(handle):
    goals[handle.get_goal_id().id].set()


def main(hz):
    global cancellations
    rospy.init_node("robot")
    cancellations = rospy.Publisher("/cancelled", Int32, queue_size=10, latch=True)
    driven = rospy.Publisher("/driven", Twist, queue_size=10)
    velocities = rospy.Subscriber("/cmd_vel", Twist, driven.publish)
    rospy.Service("/horn", Trigger, lambda request: TriggerResponse(True, "it sounds"))
    rospy.Service("/lamp", SetBool, lambda request: SetBoolResponse(request.data, "" if request.data else "it has no switch"))
    rospy.Service("/rest", Empty, lambda request: EmptyResponse())
    rospy.Service("/camera", SetCameraInfo, lambda request: SetCameraInfoResponse(True, request.camera_info.distortion_model))
    server = ActionServer("/drive", TestAction, drive, cancel, auto_start=False)
    server.start()
    needed = velocities, server.goal_sub, server.cancel_sub, driven, server.result_pub, server.feedback_pub
    clients = rospy.Publisher("/clients", Int32, queue_size=1)
    counts = rospy.Publisher("/count", Int32, queue_size=1)
    sonar = rospy.Publisher("/sonar", Range, queue_size=1)
    scans = rospy.Publisher("/scan", LaserScan, queue_size=1)
    begun, count = time.monotonic(), 0
    while not rospy.is_shutdown():
        count += 1
        counts.publish(count)
        clients.publish(min(end.get_num_connections() for end in needed))
        distance = Range(radiation_type=Range.ULTRASOUND, min_range=0.02, max_range=4.0, range=0.5 + count % 100 / 100)
        distance.header.stamp = rospy.Time.now()
        sonar.publish(distance)
        scans.publish(LaserScan(ranges=[float("inf"), float("nan"), 1.5, 0.75]))
        time.sleep(max(0.0, begun + count / hz - time.monotonic()))


try:
    main(float(sys.argv[1]) if len(sys.argv) > 1 else 20.0)
except rospy.ROSInterruptException:
    pass
