"""Installed by catkin only."""

from distutils.core import setup

from catkin_pkg.python_setup import generate_distutils_setup

setup(
    **generate_distutils_setup(
        packages=["semantic_framer"],
        package_dir={"": "src"},
        package_data={
            "semantic_framer": [
                "beginnings.yaml",
                "fragments.yaml",
                "links.yaml",
                "moods.yaml",
                "objections.yaml",
                "small_talk.yaml",
                "unread_words.yaml",
            ]
        },
    )
)
