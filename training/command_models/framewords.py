"""The verbs, particles and prepositions of the frames.

Training and evaluation sentences share them; only the open-class words differ.
A word that is listed several times is drawn more often.
"""

from typing import Tuple


def _pairs(text: str) -> Tuple[Tuple[str, str], ...]:
    return tuple((pair.split(":")[0], pair.split(":")[1]) for pair in text.split())


GOALS = """
    to to to to to into towards toward near near behind next_to in_front_of beside around past through across
    inside between out_of along at""".split()
HEADINGS = "forward forward forwards backward backwards back ahead left right straight up down sideways".split()
MOVERS = "move go drive walk come run step head travel roll navigate return proceed get advance fly slide".split()
TURNERS = "turn turn turn turn rotate spin pivot veer twist swing go".split()
PLACERS = """
    put put put put place place set leave drop hang lay stack store load stick insert pour release throw position
    rest""".split()
GIVERS = """
    give give give bring bring get fetch pass hand show find send buy offer serve make tell read grab pour lend
    throw""".split()
CARRIERS = """
    bring bring take take take carry carry move deliver drag return push send transport drive fetch transfer
    bring""".split()
TAKERS = "take take take get grab grasp fetch remove collect find pick catch find search inspect check".split()
PARTICLE_OBJECT: Tuple[Tuple[str, str], ...] = _pairs(
    """pick:up pick:up turn:on turn:on turn:on turn:off
    turn:off switch:on switch:on switch:off put:on put:down put:away put:back take:out take:off throw:away
    throw:out clean:up set:down hand:over
    plug:in shut:down open:up lift:up bring:back give:back turn:down turn:up look:up hold:up fill:up power:on fold:up
    bring:over put:on wipe:off write:down drop:off lay:down hang:up wake:up let:go pass:over move:over plug:out wash:up
    take:away take:down check:out cut:off dry:off pull:out push:in roll:up tidy:up start:up close:up wind:up"""
)
PARTICLE_ALONE: Tuple[Tuple[str, str], ...] = _pairs(
    """stand:up sit:down back:up wake:up slow:down speed:up
    hurry:up shut:down hold:on come:on look:out lie:down calm:down get:up power:down watch:out cheer:up warm:up
    back:off go:on carry:on move:on shut:up turn:around start:up clean:up"""
)
OBLIQUE: Tuple[Tuple[str, str], ...] = _pairs(
    """look:at look:at look:at look:for look:for search:for
    search:for listen:to talk:to wave:at point:at point:to connect:to play:with knock:on wait:for speak:to stop:at
    sit:on sit:in lean:on dance:with care:for think:about walk:with come:with go:with stay:with stand:in sleep:in
    disconnect:from focus:on drive:by smile:at turn:to turn:towards"""
)
VERBAL_NOUNS = "picture photo photograph nap break look step video".split()
