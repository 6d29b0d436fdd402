# Loops that wait at several places in a round, one after another or at one of them, and several times at one.
#
# expect: round_waits(A, A, "always", "1", "sleep"), round_waits(A, B, "always", "1", "sleep"), A != B, location(A, _, 24, _), location(B, _, 26, _)
# expect: 2 = count : { round_waits(_, _, "always", "1", "sleep") }
# expect: round_waits(A, A, "sometimes", "1", "sleep"), round_waits(A, B, "instead", "1", "sleep"), A != B, location(A, _, 34, _), location(B, _, 36, _)
# expect: round_waits(A, A, "always", "1", "rate"), round_waits(A, B, "sometimes", "1", "sleep"), location(B, _, 45, _), location(A, _, 46, _)
# expect: round_waits(A, A, "always", "3", "sleep"), location(A, _, 53, _)
# expect: round_waits(A, A, "sometimes", "many", "sleep"), location(A, _, 61, _)
# expect: round_without_wait(A), location(A, _, 61, _)
# expect: 1 = count : { round_without_wait(_) }
# expect: round_sends(A, [_, _, "/in_turn"], "2"), location(A, _, 24, _)
# expect-not: round_sends(A, _, _), location(A, _, 26, _)
# expect-not: round_waits(A, _, _, _, _), location(A, _, 69, _)
import rospy
from std_msgs.msg import Bool

fast = False


def in_turn():
    pub = rospy.Publisher("/in_turn", Bool, queue_size=1)
    while not rospy.is_shutdown():
        pub.publish(True)
        rospy.sleep(1.0)
        pub.publish(False)
        rospy.sleep(3.0)


def one_of_them():
    pub = rospy.Publisher("/one", Bool, queue_size=1)
    while not rospy.is_shutdown():
        pub.publish(True)
        if fast:
            rospy.sleep(0.1)
        else:
            rospy.sleep(1.0)


def sometimes_longer():
    pub = rospy.Publisher("/longer", Bool, queue_size=1)
    rate = rospy.Rate(5)
    while not rospy.is_shutdown():
        pub.publish(True)
        if fast:
            rospy.sleep(0.5)
        rate.sleep()


def three_times():
    pub = rospy.Publisher("/three_times", Bool, queue_size=1)
    while not rospy.is_shutdown():
        for _ in range(3):
            rospy.sleep(1.0)
            pub.publish(True)


def any_number(items):
    pub = rospy.Publisher("/any", Bool, queue_size=1)
    while not rospy.is_shutdown():
        for item in items:
            rospy.sleep(1.0)
            pub.publish(item)


def once():
    pub = rospy.Publisher("/once", Bool, queue_size=1)
    while not rospy.is_shutdown():
        pub.publish(True)
        rospy.sleep(1.0)


rospy.init_node("waits")
in_turn()
one_of_them()
sometimes_longer()
three_times()
any_number([True])
once()
