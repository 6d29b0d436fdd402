#!/usr/bin/env python3
# Answers that futures hand on, a timer that is destroyed, a node whose life others manage, and names that are made of its own.
#
# expect: managed_node(C)
# expect: Count = count : { answer_callback(C, F) }, Count = 3
# expect: Count = count : { activity(F, "lifecycle") }, Count = 1
# expect: activity(F, "lifecycle"), function_name(F, Name), match(".*on_activate", Name)
# expect: Count = count : { stops_timer(C, V) }, Count = 1
# expect: publisher asker/ready std_msgs/Bool
# expect: service_server ~get_state lifecycle_msgs/GetState
# expect-only: reactive * -> *
# expect-only: transition *
# expect-only: one_shot *
# expect-only: periodic *
# expect-not: _kept(_); _handled_twice(_); _always_kept(_, _); _first_value(_, _)
# expect: 21 = count : { reached_in(_, _, _) }
import rclpy
from rclpy.lifecycle import LifecycleNode
from std_msgs.msg import Bool, String
from std_srvs.srv import Trigger


class Asker(LifecycleNode):
    def __init__(self):
        super().__init__("asker")
        self.active = False
        self.open_client = self.create_client(Trigger, "open")
        self.shut_client = self.create_client(Trigger, "shut")
        self.lock_client = self.create_client(Trigger, "lock")
        self.told = self.create_publisher(String, "told", 1)
        self.done = self.create_publisher(String, "done", 1)
        self.ready = self.create_publisher(Bool, self.get_name() + "/ready", 1)
        self.create_subscription(Bool, "order", self.on_order, 1)
        self.timer = self.create_timer(0.5, self.on_once)  # expect: one_shot asker/ready 0.5 s
        self.lost = self.create_timer(2.0, self.on_often)  # expect: periodic asker/ready 0.5 Hz

    def on_order(self, message):
        future = self.open_client.call_async(Trigger.Request())  # expect: reactive order -> open must
        future.add_done_callback(self.on_open)
        self.future = self.shut_client.call_async(Trigger.Request())  # expect: reactive order -> shut must
        self.future.add_done_callback(self.on_shut)
        self.lock_client.call_async(Trigger.Request()).add_done_callback(self.on_lock)  # expect: reactive order -> lock must

    def on_open(self, future):
        self.told.publish(String())  # expect: reactive open -> told must

    def on_shut(self, future):
        self.done.publish(String())  # expect: reactive shut -> done must

    def on_lock(self, future):
        self.active = False  # expect: transition active = False on lock

    def on_once(self):
        self.ready.publish(Bool())
        self.destroy_timer(self.timer)

    def on_often(self):
        if self.active:
            self.ready.publish(Bool())
        self.destroy_timer(self.other())

    def other(self):
        return None

    def on_activate(self, state):
        self.active = True  # expect: transition active = True on lifecycle
        return self.entered()

    def entered(self):
        return super().on_activate(None)

    def on_cleanup_later(self, state):
        self.active = None


def main():
    rclpy.init()
    rclpy.spin(Asker())


if __name__ == "__main__":
    main()
