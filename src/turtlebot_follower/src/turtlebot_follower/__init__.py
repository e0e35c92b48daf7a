"""Follow me: a person follower on a point cloud, as an RFNServer."""
