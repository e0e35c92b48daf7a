"""Names of the relations and quantifiers that an argument may have, in one spelling."""

from typing import FrozenSet

#: Values of :attr:`typed_arguments.TypedArgument.relation` that declarations may use. A preposition that nobody has
#: listed is its own relation ("concerning"), so an argument may also have another one.
RELATIONS: FrozenSet[str] = frozenset(
    "to towards from on onto off in into out_of at under below over above behind in_front_of beside next_to near "
    "opposite left_of right_of between among around through across along past against up down with without for about "
    "of by as until per".split()
)
#: Those of them that a place has to all things of a list together: "between the lamp and the vase".
RELATIONS_TO_ALL: FrozenSet[str] = frozenset("between among".split())
#: Values of :attr:`typed_arguments.TypedArgument.quantifier`.
QUANTIFIERS: FrozenSet[str] = frozenset(
    "the a this that these those all every each both some any no another other several many few most enough either "
    "which what how_many how_much".split()
)
