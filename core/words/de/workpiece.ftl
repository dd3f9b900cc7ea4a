workpiece-tool-without-std = Wie unsicher das Werkzeug { $tool } ist, ist nicht bekannt ({ $keys } nicht angegeben): die Intervalle des Werkstücks enthalten davon nichts und können zu eng sein.
workpiece-no-rigid-body = Was ohne die Werkzeuge bleibt, ist kein starrer Körper: das Werkstück ist zu leicht, um es von nichts zu unterscheiden, oder ein Werkzeug ist anders als angegeben.
