# Records are made with the values that their constructor is given, which no source says.
#
# expect: state Light::on = False
# expect-only: subscriber
from dataclasses import dataclass, field
from typing import ClassVar, NamedTuple

import rospy
from foreign import Foreign
from std_msgs.msg import String


class Camera(NamedTuple):
    kind: int
    topic: str = "image"
    label: str = "camera"


@dataclass
class Arm:
    topic: str
    queue: int = 1
    frames: list = field(default_factory=list)
    name: str = field(init=False, default="arm")


@dataclass
class LongArm(Arm):
    reach: float = 1.0
    tip: str = "tip"


@dataclass
class Joined:
    base: str
    KIND: ClassVar[str] = "joined"

    def __post_init__(self):
        self.full = self.base + "/full"


@dataclass(kw_only=True)
class Named:
    place: str = "home"
    word: str


@dataclass
class Foreigner(Foreign):
    sign: str = "sign"


@dataclass
class Light:
    on: bool = False


class Viewer:
    def __init__(self, camera: Camera, arm: LongArm, joined: Joined):
        rospy.Subscriber(camera.topic, String, self.on_text)  # expect: subscriber left
        rospy.Subscriber(arm.topic, String, self.on_text)  # expect: subscriber long
        rospy.Subscriber(arm.tip, String, self.on_text)  # expect: subscriber end
        rospy.Subscriber(arm.name, String, self.on_text)  # expect: subscriber arm
        rospy.Subscriber(joined.full, String, self.on_text)  # expect: subscriber root/full
        rospy.Subscriber(joined.KIND, String, self.on_text)  # expect: subscriber joined

        self.light = Light()
        self.pub = rospy.Publisher("lit", String, queue_size=1)

    def on_text(self, message):
        if not self.light.on:
            self.pub.publish(message)
        self.light.on = True


def by_default(camera: Camera):
    rospy.Subscriber(camera.label, String, print)  # expect: subscriber camera


def by_name(named: Named, foreigner: Foreigner):
    rospy.Subscriber(named.place + "/" + named.word, String, print)  # expect: subscriber there/word
    rospy.Subscriber(foreigner.sign, String, print)  # expect: subscriber ?


rospy.init_node("viewer")
camera = Camera(1, "left")
viewer = Viewer(camera, LongArm("long", tip="end"), Joined(base="root"))
by_default(camera)
by_name(Named(place="there", word="word"), Foreigner("hand"))
rospy.spin()
