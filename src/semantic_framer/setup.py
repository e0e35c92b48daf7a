"""Installed by catkin only."""

from distutils.core import setup

from catkin_pkg.python_setup import generate_distutils_setup

PACKAGES = [
    "semantic_framer",
    "semantic_framer.asking",
    "semantic_framer.changing",
    "semantic_framer.clauses",
    "semantic_framer.filling",
    "semantic_framer.judging",
    "semantic_framer.kinds",
    "semantic_framer.linking",
    "semantic_framer.referring",
    "semantic_framer.sentences",
    "semantic_framer.units",
    "semantic_framer.values",
]
DATA = {
    "semantic_framer.changing": ["objections.yaml"],
    "semantic_framer.clauses": ["fragments.yaml"],
    "semantic_framer.judging": ["unread_words.yaml"],
    "semantic_framer.kinds": ["moods.yaml"],
    "semantic_framer.linking": ["links.yaml"],
    "semantic_framer.sentences": ["small_talk.yaml"],
}
setup(**generate_distutils_setup(packages=PACKAGES, package_dir={"": "src"}, package_data=DATA))
