"""Installed by catkin only."""

from distutils.core import setup

from catkin_pkg.python_setup import generate_distutils_setup

setup(
    **generate_distutils_setup(
        packages=["robot_fleet"], package_dir={"": "src"}, package_data={"robot_fleet": ["addresses.yaml"]}
    )
)
