"""roslaunch with the nodes in another order: ``shuffled_launch.py SEED -p PORT PACKAGE FILE [ARGUMENT ...]``."""

import random
import sys

import roslaunch.parent
import roslaunch.rlutil
import rospkg


def main() -> None:
    """Start the nodes of a launch file in an order that the seed decides, and run until an interrupt."""
    seed, _, port, package, file, *arguments = sys.argv[1:]
    path = f"{rospkg.RosPack().get_path(package)}/launch/{file}"
    run_id = roslaunch.rlutil.get_or_generate_uuid(None, False)
    parent = roslaunch.parent.ROSLaunchParent(run_id, [(path, arguments)], port=int(port))
    # The launch file is read by start(); the order of the nodes is that of its configuration.
    load = parent._load_config

    def load_shuffled() -> None:
        load()
        random.Random(int(seed)).shuffle(parent.config.nodes)

    parent._load_config = load_shuffled
    parent.start()
    parent.spin()


if __name__ == "__main__":
    main()
