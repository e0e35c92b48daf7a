"""Action servers that register for semantic frames."""

from rfnserver.rfnserver import RFNActionServer, RFNServer
from rfnserver.ros_typed_frame import TypedFrame

__all__ = ["RFNActionServer", "RFNServer", "TypedFrame"]
