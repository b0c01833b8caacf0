sick: launch/keep build/bin/scanway-sick --robot "$SCANWAY_ROBOT" $SCANWAY_SICK
schunk: launch/keep build/bin/scanway-schunk --robot "$SCANWAY_ROBOT" $SCANWAY_SCHUNK
xsens: launch/keep build/bin/scanway-xsens --robot "$SCANWAY_ROBOT" $SCANWAY_XSENS
base: launch/keep build/bin/scanway-base --robot "$SCANWAY_ROBOT" $SCANWAY_BASE
mapper: launch/keep build/bin/scanway-mapper --robot "$SCANWAY_ROBOT" --state "$SCANWAY_STATE/mapper" --maps "$SCANWAY_STATE/maps"
planner: launch/keep build/bin/scanway-planner --robot "$SCANWAY_ROBOT" --state "$SCANWAY_STATE/planner"
