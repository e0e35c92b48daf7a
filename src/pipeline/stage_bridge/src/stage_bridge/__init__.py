"""Lets a program with the messages of 2012 do the work of one stage."""
