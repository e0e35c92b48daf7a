"""All demands, in the order in which they are tried."""

from typing import Dict, Tuple

from .cores import Amounts, OddWords, Policies, WrongFiles
from .demand import Demand
from .ros_attacks import KilledNodes, LongDay, LostMaster, OddUtterances, Preemption, Stops, Storm
from .ros_launches import Clocks, StartOrders, UpAndDown
from .ros_servers import DyingServer, HungServer, LostWords
from .suite import Mutants, Repeats

_ALL: Tuple[Demand, ...] = (
    OddWords(),
    OddUtterances(),
    KilledNodes(),
    WrongFiles(),
    Preemption(),
    Stops(),
    Storm(),
    HungServer(),
    DyingServer(),
    LostWords(),
    StartOrders(),
    Clocks(),
    LongDay(),
    UpAndDown(),
    Amounts(),
    Policies(),
    LostMaster(),
    Mutants(),
    Repeats(),
)
#: By name.
DEMANDS: Dict[str, Demand] = {demand.name: demand for demand in _ALL}
