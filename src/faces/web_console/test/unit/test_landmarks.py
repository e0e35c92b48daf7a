"""Objects of the world on the map, and what can be said of them."""

from roboframenet_msgs.msg import World, WorldObject, WorldRelation

from web_console.ros_values import landmarks_of, present_objects


def seen(ident, sort, *, size=(0.0, 0.0), relations=(), states=()):
    one = WorldObject(id=ident, sort=sort, name=ident, states=list(states))
    one.pose.header.frame_id = "map"
    one.pose.pose.orientation.w = 1.0
    one.size.x, one.size.y = size
    one.relations = [WorldRelation(relation, reference) for relation, reference in relations]
    return one


WORLD = World(
    objects=[
        seen("robot", "robot"),
        seen("kitchen", "place", size=(5.0, 4.0)),
        seen("spot", "place"),
        seen("desk", "thing", size=(1.6, 0.8), relations=[("in", "kitchen")]),
        seen("mug", "thing", relations=[("on", "desk"), ("in", "kitchen")]),
        seen("box", "thing", relations=[("on", "kitchen")]),
        seen("pen", "thing", relations=[("held_by", "robot")]),
        seen("lamp", "device", size=(0.1, 0.1), states=("on",)),
    ]
)


def test_edges_make_rooms_and_furniture():
    kinds = {one.name: one.kind for one in landmarks_of(WORLD)}
    assert kinds == {
        "kitchen": "room",
        "spot": "place",
        "desk": "furniture",
        "mug": "thing",
        "box": "thing",
        "pen": "thing",
        "lamp": "device",
    }
    kitchen = landmarks_of(WORLD)[0]
    assert (kitchen.width_m, kitchen.depth_m, kitchen.heading_rad) == (5.0, 4.0, 0.0)


def test_what_the_robot_holds_is_marked():
    assert [one.name for one in landmarks_of(WORLD) if one.is_held] == ["pen"]


def test_what_lies_on_furniture_can_be_taken():
    present = {one.name: one for one in present_objects(WORLD)}
    assert [name for name, one in present.items() if one.is_loose] == ["mug"]
    assert [name for name, one in present.items() if one.carries] == ["kitchen", "desk"]
    assert present["pen"].holder == "robot"
