"""For rostests of abilities; no product code imports this package."""

from roboframenet_rostest.ros_pipeline import can_do, say, wait_for_pipeline

__all__ = ["can_do", "say", "wait_for_pipeline"]
