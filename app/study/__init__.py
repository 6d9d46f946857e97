"""Error against run time: the studies that lessons declare, measured, told and drawn (`halfway study`)."""
