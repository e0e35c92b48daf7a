"""Installed by catkin only."""

from distutils.core import setup

from catkin_pkg.python_setup import generate_distutils_setup

PACKAGES = [
    "utterance_passes",
    "utterance_passes.asides",
    "utterance_passes.deeds",
    "utterance_passes.engine",
    "utterance_passes.messages",
    "utterance_passes.phrases",
    "utterance_passes.repairs",
    "utterance_passes.sharing",
    "utterance_passes.slips",
    "utterance_passes.trees",
    "utterance_passes.wording",
]
DATA = {
    "utterance_passes.trees": ["formulas.yaml"],
}
setup(**generate_distutils_setup(packages=PACKAGES, package_dir={"": "src"}, package_data=DATA))
