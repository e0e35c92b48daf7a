"""Action servers that register for semantic frames."""

from rfnserver.rfnserver import RFNActionServer, RFNServer
from rfnserver.ros_condition_server import ConditionServer, ConditionUnknown, Observed
from rfnserver.ros_typed_frame import TypedFrame

__all__ = ["ConditionServer", "ConditionUnknown", "Observed", "RFNActionServer", "RFNServer", "TypedFrame"]
