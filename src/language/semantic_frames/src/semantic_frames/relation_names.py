"""Names of grammatical relations that a lexical unit may use.

Universal Dependencies v2 (universaldependencies.org/u/dep) and the Stanford Dependencies manual (de Marneffe and
Manning, 2008, revised 2013), basic and collapsed.
"""

import re
from typing import FrozenSet, Tuple

UNIVERSAL: FrozenSet[str] = frozenset(
    "nsubj obj iobj csubj ccomp xcomp obl vocative expl dislocated advcl advmod discourse aux cop mark nmod appos "
    "nummod acl amod det clf case conj cc fixed flat compound list parataxis orphan goeswith reparandum punct "
    "root dep".split()
)
STANFORD: FrozenSet[str] = frozenset(
    "abbrev acomp advcl advmod agent amod appos attr aux auxpass cc ccomp complm conj cop csubj csubjpass dep det "
    "discourse dobj expl goeswith infmod iobj mark mwe neg nn npadvmod nsubj nsubjpass num number parataxis "
    "partmod pcomp pobj poss possessive preconj predet prep prepc prt punct purpcl quantmod rcmod ref rel root "
    "tmod vmod vocative xcomp xsubj".split()
)
#: Measures relate to the verb in several ways ("3 feet" as obl:unmarked, dobj, tmod): this name stands for all of them.
MEASURE = "measure"
#: Where something is may be said with any preposition of place: this name stands for all of their relations.
PLACE = "place"
RELATIONS_OF_PLACE: Tuple[str, ...] = tuple(
    "prep_in prep_on prep_at prep_near prep_next_to prep_close_to prep_beside prep_by prep_in_front_of prep_behind "
    "prep_inside prep_under prep_underneath prep_below prep_beneath prep_over prep_above prep_between prep_against "
    "prep_on_top_of".split()
)
#: Relations whose name continues with a word of the sentence or with a subtype.
_OPEN = re.compile(r"^(prep|prepc|conj)_[a-z_]+$|^[a-z]+:[a-z_]+$")


def is_relation_name(name: str) -> bool:
    """Whether a lexical unit may use the name; any word may follow the first part of "obl:to" and "prep_to"."""
    if name in UNIVERSAL or name in STANFORD or name in (MEASURE, PLACE):
        return True
    return bool(_OPEN.match(name)) and re.split("[:_]", name)[0] in UNIVERSAL | STANFORD
