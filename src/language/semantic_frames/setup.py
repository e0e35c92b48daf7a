"""Installed by catkin only."""

from distutils.core import setup

from catkin_pkg.python_setup import generate_distutils_setup

setup(
    **generate_distutils_setup(
        packages=["semantic_frames"],
        package_dir={"": "src"},
        package_data={"semantic_frames": ["extra_thematic.yaml", "roles.yaml"]},
    )
)
