"""The file of the standing orders: everything comes back, and a broken file is set aside."""

import sqlite3
from datetime import datetime, time

import pytest

from roboframenet_ros.sqlite_file import StoreError
from standing_orders.order import StandingOrder
from standing_orders.schedule import After, Daily, Every, Once
from standing_orders.store import Store

ORDERS = [
    StandingOrder(
        f"o{number}", "say it", "say it", "I will say it.", b"\x00\xff", float(number), schedule, 9.5, number > 2
    )
    for number, schedule in enumerate(
        [None, Once(datetime(2026, 11, 22, 20)), After(10.5), Every(1.5, 2.5), Daily(time(7, 30), (0, 6))]
    )
]


def test_orders_come_back_as_they_were(tmp_path):
    path = str(tmp_path / "deep" / "orders.sqlite")
    store = Store(path)
    store.write(ORDERS, ())
    # No close: the process was killed.
    assert Store(path).load() == tuple(ORDERS)
    store.write(ORDERS[:1], ["o1", "o2"])
    again = Store(path)
    assert [order.order_id for order in again.load()] == ["o0", "o3", "o4"]
    assert again.problems == ()


@pytest.mark.parametrize(
    "entry", ["", "{}", "[]", '{"schedule": {"kind": "Never"}}', '{"schedule": null, "plan": "?"}']
)
def test_entry_that_cannot_be_read_is_left_out(tmp_path, entry):
    path = str(tmp_path / "orders.sqlite")
    store = Store(path)
    store.write(ORDERS[:1], ())
    store.close()
    with sqlite3.connect(path) as file:
        file.execute("INSERT INTO orders VALUES ('bad', ?)", (entry,))
    again = Store(path)
    assert again.load() == (ORDERS[0],)
    assert "'bad' is left out" in again.problems[0]


def test_file_that_is_none_is_set_aside(tmp_path):
    path = tmp_path / "orders.sqlite"
    path.write_text("no database, but quite a long text " * 100)
    store = Store(str(path))
    assert store.load() == ()
    assert "is kept as" in store.problems[0]
    store.write(ORDERS, ())
    assert len(Store(str(path)).load()) == len(ORDERS)


def test_folder_that_cannot_be_made_is_an_error(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(StoreError, match="cannot be opened"):
        Store(str(tmp_path / "file" / "orders.sqlite"))
