"""The words of the generator, in two disjoint lists: TRAINING and EVALUATION.

Words of the evaluation list never occur in the generated training sentences, and the tool also drops
every treebank sentence that has one (see ``treebanks``).  What both halves share is the closed-class
vocabulary and the frame verbs (go, turn, put, ...) that the frames are made of.
"""

from dataclasses import dataclass, fields
from typing import FrozenSet, Set, Tuple


def _words(text: str) -> Tuple[str, ...]:
    return tuple(text.split())


@dataclass(frozen=True)
class Lexicon:
    """Open-class words by their place in a frame; multi-word nouns are joined by ``_``."""

    things: Tuple[str, ...]  # what can be carried
    masses: Tuple[str, ...]  # uncountable: no plural, no "a"
    fixtures: Tuple[str, ...]  # furniture and devices: landmarks, supports, what is opened or switched
    places: Tuple[str, ...]  # rooms and regions
    people: Tuple[str, ...]
    names: Tuple[str, ...]
    robots: Tuple[str, ...]  # what the robot is called: the vocatives
    adjectives: Tuple[str, ...]
    states: Tuple[str, ...]  # adjectives said of a thing: "is the door open"
    transitive: Tuple[str, ...]  # verbs with an object
    intransitive: Tuple[str, ...]
    manners: Tuple[str, ...]  # adverbs of manner
    gestures: Tuple[str, ...]  # "give me a hug"
    noise: Tuple[str, ...]  # what a robot says or plays


TRAINING = Lexicon(
    things=_words(
        """
        cup mug glass plate bowl bottle can jar knife fork spoon pan pot lid tray box bag basket bucket book magazine
        newspaper paper letter message parcel envelope pen pencil ruler notebook laptop computer phone mobile_phone
        cell_phone telephone tablet mouse keyboard remote remote_control remote_controller charger cable wire battery
        key wallet purse coat jacket shirt t-shirt hat scarf shoe slipper sock towel rag cloth sponge brush broom mop
        pillow cushion blanket sheet toy ball doll block cube apple banana orange lemon tomato potato carrot onion
        cucumber egg sandwich cake biscuit snack drink beer coke soda toothbrush comb mirror candle vase flower plant
        screwdriver hammer wrench drill nail tool rope ladder tissue_box toilet_roll coffee_mug tea_cup wine_glass
        guitar picture photo card ticket cigarette lighter pill medicine_box umbrella watch camera radio
        salt_shaker cereal_box juice_carton water_bottle trash_bin bin garbage_bag shovel barrel cone
        painting statue clock alarm_clock disk cd file document folder vegetable fruit slice bat basketball"""
    ),
    masses=_words(
        """
        water milk coffee tea juice wine bread butter cheese rice sugar salt soup yogurt food meat rubbish garbage
        laundry paper music soap toast lettuce fish dust news mail luggage breakfast lunch dinner stuff"""
    ),
    fixtures=_words(
        """
        table desk chair sofa couch bed shelf cupboard cabinet closet wardrobe drawer counter sink fridge refrigerator
        oven stove microwave dishwasher washing_machine television tv lamp light window door curtain fan heater radio
        switch stereo armchair bench stool nightstand bedside_table coffee_table dining_table kitchen_table side_table
        bookshelf bathtub shower toilet fireplace socket power_socket wall gate stairs ladder tap faucet carpet rug
        printer monitor screen board whiteboard bookcase dresser rack box pantry main_door front_door oven_door
        dinner_table tv_stand doorway machine elevator charger station"""
    ),
    places=_words(
        """
        kitchen bathroom bedroom living_room dining_room office hallway hall corridor garden garage studio studio_room
        laundry_room lobby entrance exit room library lab laboratory classroom meeting_room restroom toilet balcony
        terrace basement cellar attic building house apartment corner door street shop store hotel dinner_room
        livingroom guest_room conference_room playroom yard center middle reception starting_point stair landing"""
    ),
    people=_words(
        """
        man woman person boy girl child guy lady mother father brother sister friend guest visitor doctor nurse
        teacher student neighbor waiter manager boss baby kid grandmother grandfather postman operator team class"""
    ),
    names=_words(
        """
        Roger Anna Peter Maria John Mary Michael Sarah David Laura Tom Susan Paul Julia Robert Linda James Emma Mark
        Karen Daniel Marco Alice Bob Charles Diana Eric Frank Helen Jack Kate Luke Nina Oliver Sam Victor Ben Brian"""
    ),
    robots=_words("Robbie Max Rob buddy Pepper Nao Baxter Marvin Alfred Jarvis dude man sir"),
    adjectives=_words(
        """
        red blue green yellow black white brown grey big small large little old new long short clean dirty empty full
        heavy light hot cold wooden plastic metal round square tall soft pink orange purple dark bright fresh broken
        nearest closest other next last first second third main left right far near empty wet dry thin thick warm violet
        magenta scarlet maroon golden silver teal lilac cyan navy khaki triangular oval cubic flat curved shallow huge
        enormous miniature sturdy delicate spotted dotted checkered opaque dull smooth rough dented faded"""
    ),
    states=_words(
        """
        open closed on off hot cold clean dirty empty full ready locked free busy warm wet dry here there unfinished
        unoccupied untidy unused unharmed undamaged occupied crowded dusty tidy safe broken"""
    ),
    transitive=_words(
        """
        take grab grasp get find fetch bring carry hold lift open close clean wash wipe check inspect examine watch
        follow guide show touch push pull press move place drop release throw kick catch cut chop slice peel scrub rinse
        dry fold iron sweep mop vacuum dust water feed fill empty pour stir mix cook boil bake heat warm cool cover
        wrap unwrap pack unpack load unload stack sort count collect gather remove replace fix repair mount attach
        detach connect disconnect unlock lock start stop pause play record film photograph scan read print copy paint
        draw write name call phone greet welcome hug tickle help visit enter leave reach cross pass explore search
        locate detect recognize identify point track monitor guard use test adjust raise lower tilt shake squeeze
        twist rotate turn spin roll slide drag hang store keep save buy order serve offer deliver hand send describe
        explain remember forget learn repeat say sing tell answer ask enjoy finish continue cancel hide steady set
        prepare
        make control activate charge ignore approach avoid tidy water switch face center align nudge shut grip eat
        drink"""
    ),
    intransitive=_words(
        """
        stop wait go come move walk run drive turn rotate spin dance sing speak talk listen sleep wake rest sit stand
        jump hop roll stay return leave continue begin start finish proceed advance reverse wave nod smile laugh
        relax freeze hurry explore charge recharge dock undock ping park beep bow crouch kneel stretch swim fly climb
        look search pause halt retreat drift circle patrol help try work think breathe swing shake step veer pivot
        calibrate reboot restart repeat answer knock"""
    ),
    manners=_words(
        """
        slowly quickly carefully gently quietly fast immediately closely straight carefully smoothly softly faster
        slower backwards sideways together alone again now here there upstairs downstairs outside inside"""
    ),
    gestures=_words("hug kiss smile wave hand high_five fist_bump break moment minute second chance"),
    noise=_words("song joke story poem melody name sentence word"),
)

EVALUATION = Lexicon(
    things=_words(
        """
        thermos ladle spatula colander whisk stapler calculator teapot saucer corkscrew grater flashlight helmet
        binder cardigan sandal pineapple zucchini muffin marker shampoo hairbrush trophy kettle"""
    ),
    masses=_words("honey mustard flour lemonade detergent oatmeal"),
    fixtures=_words("hutch bureau freezer toaster dryer thermostat chandelier recliner crib ottoman pedestal blender"),
    places=_words("pharmacy nursery gymnasium foyer veranda cafeteria workshop greenhouse vestibule canteen"),
    people=_words("janitor dentist plumber grandson niece cousin librarian carpenter"),
    names=_words("Gustav Priya Leonard Beatrice Hamid Ingrid Tobias Yolanda Winston Fiona"),
    robots=_words("Zeno Rover Clank Tinman Optimus Gizmo"),
    adjectives=_words("crimson turquoise tiny shiny fragile rectangular striped beige transparent rusty"),
    states=_words("ajar unlocked spotless unplugged lukewarm"),
    transitive=_words(
        """
        rummage hoist polish marinate dismantle sterilize tow retrieve unscrew juggle mash disinfect assemble sprinkle
        drain puncture caress wiggle"""
    ),
    intransitive=_words("crawl twirl tiptoe meditate whistle yawn wobble levitate applaud stroll hibernate scoot"),
    manners=_words("cautiously briskly silently steadily clumsily"),
    gestures=_words("salute massage"),
    noise=_words("riddle lullaby"),
)


def content_words(lexicon: Lexicon) -> FrozenSet[str]:
    """Return every word of a lexicon in lower case, with multi-word entries split."""
    found: Set[str] = set()
    for field in fields(lexicon):
        for entry in getattr(lexicon, field.name):
            found.update(part.lower() for part in entry.split("_"))
    return frozenset(found)


def evaluation_words() -> FrozenSet[str]:
    """Return the words that must not occur in training: all open-class words of the evaluation list."""
    return content_words(EVALUATION)
