"""Moves and turns a base by spoken amounts: odometry in, velocity out."""
