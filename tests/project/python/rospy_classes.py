#!/usr/bin/env python
# Members, inheritance, parameters, services, timers, lambdas, functools.partial and names that are put together.
#
# expect: component rospy_classes node_name=arm
# expect: reactive pose -> ~arm/pose must
# expect: reactive reset -> left/moved
# expect: reactive reset -> right/moved
# expect: periodic ~status 2 Hz mechanism=timer
# expect-not: publisher unused
# expect-only: publisher
# expect-only: subscriber
# expect-only: param
from functools import partial

import rospy
from geometry_msgs.msg import Pose
from std_msgs.msg import Empty, String
from std_srvs.srv import Trigger, TriggerResponse


class Part(object):
    def __init__(self, name, size=3):
        self.name = name
        self.moved = rospy.Publisher('%s/moved' % name, Empty, queue_size=size)  # expect: publisher left/moved std_msgs/Empty queue=3
        # the other object of this class
        # expect: publisher right/moved queue=4

    def move(self):
        self.moved.publish()

    def unused(self):
        return rospy.Publisher('unused', Empty, queue_size=1)


class Base(object):
    def __init__(self):
        rospy.init_node('arm')
        self.frame = rospy.get_param('~frame', 'base')  # expect: param ~frame = base op=read
        self.status = rospy.Publisher('~status', String, latch=True, queue_size=1)  # expect: publisher ~status std_msgs/String latched
        self.setup()

    def setup(self):
        raise NotImplementedError

    def tell(self, _event):
        self.status.publish(self.frame)


class Arm(Base):
    def setup(self):
        self.out = rospy.Publisher('{}/{}/pose'.format('~', 'arm'), Pose, queue_size=1)  # expect: publisher ~arm/pose
        self.parts = [Part('left'), Part('right', size=4)]
        rospy.Subscriber('pose', Pose, lambda pose: self.out.publish(pose))  # expect: subscriber pose geometry_msgs/Pose
        for name in ['a', 'b']:
            rospy.Subscriber(f'input/{name}', Pose, partial(self.on_input, name))  # expect: subscriber input/a callback=Arm::on_input
            # and of the other
            # expect: subscriber input/b via=bind
        rospy.Service('reset', Trigger, self.reset)  # expect: service_server reset std_srvs/Trigger callback=Arm::reset
        self.timer = rospy.Timer(rospy.Duration(0.5), self.tell)

    def on_input(self, name, pose):
        rospy.loginfo('%s %s', name, pose)

    def reset(self, _request):
        for part in self.parts:
            part.move()
        return TriggerResponse(success=True)


if __name__ == '__main__':
    Arm()
    rospy.spin()
