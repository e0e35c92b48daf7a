"""Names of the relations that an argument may have: what its preposition means, in one spelling."""

from typing import FrozenSet

#: Values of :attr:`typed_arguments.TypedArgument.relation` that declarations may use. A preposition that nobody has
#: listed is its own relation ("concerning"), so an argument may also have another one.
RELATIONS: FrozenSet[str] = frozenset(
    "to towards from on onto off in into out_of at under below over above behind in_front_of beside next_to near "
    "opposite left_of right_of between among around through across along past against up down with without for about "
    "of by as until per".split()
)
