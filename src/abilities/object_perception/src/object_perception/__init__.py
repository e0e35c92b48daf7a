"""Tells the world what cameras see: detections in images, detections in space, and tags."""
