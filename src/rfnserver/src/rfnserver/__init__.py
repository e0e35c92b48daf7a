"""Action servers that register for semantic frames."""

from rfnserver.rfnserver import RFNActionServer, RFNServer

__all__ = ["RFNActionServer", "RFNServer"]
