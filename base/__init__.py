"""General tools that know nothing of ROS or Datalog: worker processes, caches, limits, files, diagnostics, readers of XML and YAML."""
