"""Robot descriptions: xacro evaluated without running anything, and the simulator plugins that a description loads.

`expand` gives the document that the xacro program would write, with the place of every element in the files it is made of; `plugins` lists
the plugins of such a document, of a URDF or of an SDF file.

Sources: the xacro format (wiki.ros.org/xacro) and the behaviour of xacro 1.9 to 1.14.
"""

import rosarch.extractor.launch  # noqa: F401  (launch files name descriptions: whichever is imported first, the other is complete)
from rosarch.extractor.urdf.model import IN_ORDER, NOETIC, TRADITIONAL, Dialect, Expansion
from rosarch.extractor.urdf.plugins import SimulatorPlugin, plugins
from rosarch.extractor.urdf.writer import write
from rosarch.extractor.urdf.xacro import expand

__all__ = ["IN_ORDER", "NOETIC", "TRADITIONAL", "Dialect", "Expansion", "SimulatorPlugin", "expand", "plugins", "write"]
