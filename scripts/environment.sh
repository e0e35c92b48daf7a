# Sourced by the other scripts: the environment of the workspace; nodes listen on this machine only. One port is an
# exception that no setting changes: the XML-RPC server of roscpp, which the node rosout uses, listens on all addresses.
if [ ! -f devel/setup.bash ]; then
  echo "devel/setup.bash is missing: run 'make build' first." >&2
  exit 1
fi
unset PYTHONPATH PYTHONHOME
# In a function: the files of catkin would read the arguments of the script that sources this one.
source_workspace() { set --; . devel/setup.bash; }
source_workspace
export ROS_HOSTNAME=${ROS_HOSTNAME:-127.0.0.1}
# roscpp binds its topics to the loopback device for this variable only.
if [ "$ROS_HOSTNAME" = 127.0.0.1 ]; then export ROS_IP=${ROS_IP:-127.0.0.1}; fi
export ROS_HOME=${ROS_HOME:-$PWD/.ros}
export ROS_LOG_DIR=${ROS_LOG_DIR:-$ROS_HOME/log}
export PYTHONUNBUFFERED=1
mkdir -p "$ROS_LOG_DIR"
