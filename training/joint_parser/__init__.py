"""Trains one network on a pretrained encoder that tags words and finds their heads."""
