# RoboFrameNet: 'make demo' shows it, 'make test' checks it; both set up what they need.
SHELL := /bin/bash
.DEFAULT_GOAL := help
ROBOT ?= turtlebot
FILTER ?=

.PHONY: help setup build demo run test lint bench install clean

help: ## list the targets
	@grep -hE '^[a-z]+:.*## ' $(MAKEFILE_LIST) | sed -E 's/^([a-z]+):.*## /  make \1|/' | column -t -s '|'

setup: ## install system packages and the Python environment (root or sudo)
	@scripts/setup

build: setup ## build the workspace into devel/
	@scripts/build

demo: build ## start simulated robots, say the paper's sentences, show what each did
	@scripts/demo

run: build ## keep the stack up for your own 'rostopic pub' (ROBOT=pr2 for the other robot)
	@scripts/run robot:=$(ROBOT)

test: build ## run all tests (FILTER=package runs one package's)
	@scripts/test $(if $(FILTER),-R $(FILTER))

lint: build ## check packages and launch files with catkin_lint
	@. scripts/environment.sh && catkin_lint --offline src underlay tests

bench: build ## compare with stock Stanza and stock actionlib (EWT=folder: score the parser on the treebank)
	@EWT="$(abspath $(EWT))" HURIC="$(abspath $(HURIC))" scripts/bench

install: build ## install into install/ (DESTDIR-style: set PREFIX to choose another folder)
	@scripts/install $(PREFIX)

clean: ## remove what was built; the Python environment stays
	@rm -rf build devel install .ros
