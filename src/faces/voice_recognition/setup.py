"""Installed by catkin only."""

from distutils.core import setup

from catkin_pkg.python_setup import generate_distutils_setup

setup(
    **generate_distutils_setup(
        packages=["voice_recognition"],
        package_dir={"": "src"},
        package_data={"voice_recognition": ["voice.yaml"]},
    )
)
