/** Absagen, Stopps und ihre Gründe: nach den englischen Worten des Dienstes, `{}` für das, was sie nennen, in derselben Reihenfolge. */
export const sentences: Record<string, string> = {
  '{}: found {}, expected {}': '{}: gefunden: {}, erwartet: {}',

  // the guard
  '{}; the robot was stopped. {}': '{}; der Roboter wurde gestoppt. {}',
  '{} is {} m from {} (limit {} m); the robot was stopped. {}':
    '{} ist {} m von {} entfernt (Grenze {} m); der Roboter wurde gestoppt. {}',
  '{} would stop {} m from {} (limit {} m); the robot was stopped. {}':
    '{} käme erst {} m vor {} zum Stehen (Grenze {} m); der Roboter wurde gestoppt. {}',
  'zone "{}"': 'Zone „{}“',
  'obstacle "{}"': 'Hindernis „{}“',
  'joint {}': 'Gelenk {}',
  payload: 'die Last',
  "the robot's state is not finite": 'der Zustand des Roboters enthält Werte, die keine Zahlen sind',
  'the commanded position is not finite': 'die befohlene Stellung enthält Werte, die keine Zahlen sind',
  "the robot's clock went on by {} ms in one period (expected {} ms), its state is stale":
    'die Uhr des Roboters ging in einer Periode um {} ms weiter (erwartet {} ms), sein Zustand ist veraltet',
  "the robot's state came after {} ms (limit {} ms)":
    'der Zustand des Roboters kam nach {} ms (Grenze {} ms)',
  '{} is at {} rad (limit {} rad)': '{} steht bei {} rad (Grenze {} rad)',
  '{} was commanded at {} rad (limit {} rad)': '{} sollte auf {} rad (Grenze {} rad)',
  '{} moves at {} rad/s (limit {} rad/s)': '{} bewegt sich mit {} rad/s (Grenze {} rad/s)',
  '{} was commanded at {} rad/s (limit {} rad/s)': '{} sollte sich mit {} rad/s bewegen (Grenze {} rad/s)',
  '{} moves at {} m/s (limit {} m/s)': '{} bewegt sich mit {} m/s (Grenze {} m/s)',
  '{} was commanded at {} m/s (limit {} m/s)': '{} sollte sich mit {} m/s bewegen (Grenze {} m/s)',
  '{} of {} is {} N (range {} N)': '{} von {} ist {} N (Messbereich {} N)',
  '{} of {} is {} N m (range {} N m)': '{} von {} ist {} N m (Messbereich {} N m)',
  '{} is {} rad from its command (limit {} rad)': '{} ist {} rad von seinem Befehl entfernt (Grenze {} rad)',
  "the wrench has not changed for {} s (limit {} s), a live sensor shows its noise; the robot was stopped. Check the sensor's connection and start again.":
    'Kraft und Moment haben sich {} s lang nicht geändert (Grenze {} s), ein lebender Sensor rauscht; der Roboter wurde gestoppt. Prüfen Sie den Anschluss des Sensors und beginnen Sie noch einmal.',
  'Check the connection to robot and sensor and start again.':
    'Prüfen Sie die Verbindung zu Roboter und Sensor und beginnen Sie noch einmal.',
  'Check the connection to the robot and start again.':
    'Prüfen Sie die Verbindung zum Roboter und beginnen Sie noch einmal.',
  'Take load off the computer or its network and start again.':
    'Entlasten Sie den Rechner oder sein Netz und beginnen Sie noch einmal.',
  'Move it back by hand guiding and plan again.': 'Führen Sie ihn von Hand zurück und planen Sie neu.',
  'Check for contact, or take a lighter payload or a larger sensor.':
    'Prüfen Sie, ob er etwas berührt, oder nehmen Sie eine leichtere Last oder einen größeren Sensor.',
  "Check the joint's controller and the load settings and start again.":
    'Prüfen Sie den Regler des Gelenks und die eingestellte Last und beginnen Sie noch einmal.',
  'Check where it stands and plan again.': 'Prüfen Sie, wo es steht, und planen Sie neu.',
  'Clear the zone and start again.': 'Räumen Sie die Zone und beginnen Sie noch einmal.',
  'Plan again.': 'Planen Sie neu.',
  'joint {} stands {} rad from where the trajectory starts (limit {} rad); the robot has not followed it. Plan again from where the robot stands.':
    'Gelenk {} steht {} rad von dort, wo die Bewegung beginnt (Grenze {} rad); der Roboter ist ihr nicht gefolgt. Planen Sie neu von dort, wo er steht.',
  'the rotation about sensor axis {} stands still at {} % of its profile: joint {} is {} rad from its limit, or the arm is singular; the robot was stopped. Choose another start configuration.':
    'die Drehung um die Sensorachse {} steht bei {} % ihres Profils: Gelenk {} ist {} rad vor seiner Grenze, oder der Arm ist singulär; der Roboter wurde gestoppt. Wählen Sie eine andere Startstellung.',
  "joint {}: commanded position {} rad (limit {} rad); the drives refused it and stopped. Check the plan's joint limits.":
    'Gelenk {}: befohlene Stellung {} rad (Grenze {} rad); die Antriebe nahmen sie nicht an und stoppten. Prüfen Sie die Gelenkgrenzen des Plans.',
  "joint {}: commanded {} rad away in one period, {} rad/s (limit {} rad/s); the drives refused it and stopped. Start from the robot's present q_cmd.":
    'Gelenk {}: {} rad in einer Periode befohlen, {} rad/s (Grenze {} rad/s); die Antriebe nahmen es nicht an und stoppten. Beginnen Sie bei der jetzt befohlenen Stellung.',
  'command {}: expected {} finite joint positions; the robot was stopped.':
    'Befehl {}: erwartet {} endliche Gelenkstellungen; der Roboter wurde gestoppt.',
  'a command after a stop; call release() when it is safe to go on.':
    'ein Befehl nach einem Stopp; geben Sie frei, sobald es sicher weitergehen kann.',
  'the robot was asked to pause; it keeps its place until it is told to go on.':
    'der Roboter sollte anhalten; er bleibt, wo er ist, bis er fortfahren soll.',
  '{}; the robot was stopped and keeps its place. Resume the run when the cause is gone.':
    '{}; der Roboter wurde gestoppt und bleibt, wo er ist. Lassen Sie den Lauf fortfahren, sobald die Ursache behoben ist.',
  'no answer from the console for {}: the connection was late or is lost':
    'keine Antwort vom bedienenden Bildschirm seit {}: die Verbindung war zu langsam oder ist verloren',
  "the console's page has not responded for {}: the tablet is too busy, or the page stands still":
    'die Seite auf dem bedienenden Bildschirm reagierte nicht seit {}: das Tablet ist überlastet, oder die Seite steht still',
  'no sign of life from the service for {}: its computer is too busy, or it was stopped':
    'kein Lebenszeichen vom Dienst seit {}: sein Rechner ist überlastet, oder er wurde angehalten',
  'the control process got no time for {}: its computer is too busy':
    'die Steuerung bekam keine Rechenzeit seit {}: ihr Rechner ist überlastet',
  '{} ms (limit {} ms)': '{} ms (Grenze {} ms)',
  'the database has not taken what happened for {} s (limit {} s); the robot was stopped and keeps its place, and nothing is lost. Resume the run when the database is back.':
    'die Datenbank nahm seit {} s nicht auf, was geschah (Grenze {} s); der Roboter wurde gestoppt und bleibt, wo er ist, und nichts ist verloren. Lassen Sie den Lauf fortfahren, sobald die Datenbank wieder da ist.',
  'nobody has been in control of the robot for {} s while it was on hold (limit {} s); the run was ended. Begin the rest of it as a new run.':
    'seit {} s bediente niemand den Roboter, während er angehalten war (Grenze {} s); der Lauf wurde beendet. Beginnen Sie seinen Rest als neuen Lauf.',
  'the robot stands {} rad from where it was stopped (limit {} rad); somebody has moved it. Begin the rest as a new run, which is planned from where it stands.':
    'der Roboter steht {} rad von dort, wo er gestoppt wurde (Grenze {} rad); jemand hat ihn bewegt. Beginnen Sie den Rest als neuen Lauf, der von dort geplant wird, wo er steht.',
  'interrupted after {} s of motion; the robot was stopped{}.':
    'nach {} s Bewegung unterbrochen; der Roboter wurde gestoppt{}.',
  ' and the recording so far closed in {}': ', die Aufzeichnung bis dahin steht in {}',

  'speed_m_s is {} m/s; this cell allows {} to {} m/s':
    'speed_m_s ist {} m/s; diese Zelle erlaubt {} bis {} m/s',
  'start_rad has {} joint positions; this robot has {} joints':
    'start_rad hat {} Gelenkstellungen; dieser Roboter hat {} Gelenke',

  // no safe way
  'no start configuration with sensor axis {} along gravity: rejected {}. Move what is in the way, reduce the payload box, limits.clearance_m or limits.self_clearance_m, or search more (--effort), and plan again.':
    'keine Startstellung mit der Sensorachse {} längs der Schwerkraft; ausgeschieden: {}. Räumen Sie weg, was im Weg ist, verkleinern Sie den Hüllquader, limits.clearance_m oder limits.self_clearance_m, oder suchen Sie mehr (--effort), und planen Sie neu.',
  'no start configuration with sensor axis {} along gravity: rejected {}; the best clearance met was {} m to {}. Move what is in the way, reduce the payload box, limits.clearance_m or limits.self_clearance_m, or search more (--effort), and plan again.':
    'keine Startstellung mit der Sensorachse {} längs der Schwerkraft; ausgeschieden: {}; der größte Abstand, der sich fand, war {} m zu {}. Räumen Sie weg, was im Weg ist, verkleinern Sie den Hüllquader, limits.clearance_m oder limits.self_clearance_m, oder suchen Sie mehr (--effort), und planen Sie neu.',
  '{} There is a plan for the other sensor axes: --axes {}.':
    '{} Für die anderen Sensorachsen gibt es einen Plan: --axes {}.',
  'nothing, no candidate': 'nichts, es gab keine Stellung',
  'unreachable {}': 'unerreichbar {}',
  'too close to {}': 'zu nah an {}',
  '{} too close to {}': '{} zu nah an {}',
  'a released load would fly into zone {}': 'eine Last, die sich löst, flöge in die Zone {}',
  '{} too weak to hold the load': '{} zu schwach, um die Last zu halten',
  'no room for the rotation: {}': 'kein Platz für die Drehung: {}',
  'joint limits during the rotation {}': 'Gelenkgrenzen während der Drehung {}',
  'joint velocity during the rotation {}': 'Gelenkgeschwindigkeit während der Drehung {}',
  'joint acceleration during the rotation {}': 'Gelenkbeschleunigung während der Drehung {}',
  'Cartesian speed during the rotation {}': 'Geschwindigkeit im Raum während der Drehung {}',
  'a corner of the path at {} rad cannot be rounded by {} rad without coming closer than the clearance. Plan again with another seed, or give the path more room.':
    'eine Ecke des Weges bei {} rad lässt sich nicht um {} rad runden, ohne dem Abstand zu nahe zu kommen. Planen Sie neu mit einem anderen Startwert, oder geben Sie dem Weg mehr Platz.',
  'the {} of the path is {}, expected {} finite joint positions in rad.':
    '{} des Weges: {}, erwartet {} endliche Gelenkstellungen in rad.',
  'the {} of the path has {} at {} rad, outside its limits [{}, {}] rad. Choose another {} configuration.':
    '{} des Weges: {} bei {} rad, außerhalb seiner Grenzen [{}, {}] rad. Wählen Sie eine andere Stellung.',
  'at the {} of the path {} is {} m from {} (limit {} m). Choose another {} configuration or clear the cell.':
    '{} des Weges: {} ist {} m von {} entfernt (Grenze {} m). Wählen Sie eine andere Stellung oder räumen Sie die Zelle.',
  start: 'Anfang',
  goal: 'Ende',
  'no path found in {} iterations by {}: the search from the start came within {} rad of the goal, {} rad away; the tighter end has {} {} m from {} (limit {} m). Search more (--effort), choose another start configuration, or clear the cell.':
    'kein Weg gefunden in {} Durchgängen mit {}: die Suche kam bis auf {} rad an das Ziel, das {} rad entfernt ist; am engeren Ende ist {} {} m von {} (Grenze {} m). Suchen Sie mehr (--effort), wählen Sie eine andere Startstellung oder räumen Sie die Zelle.',
  'no room for a wide-band motion: even joint swings of {} mrad leave the limits, come too close to something, or could throw a load into a zone. Choose another motion, or give the robot more room.':
    'kein Platz für eine breitbandige Bewegung: schon Ausschläge von {} mrad verlassen die Grenzen, kommen etwas zu nahe oder könnten eine Last in eine Zone werfen. Wählen Sie eine andere Bewegung, oder geben Sie dem Roboter mehr Platz.',
  'no timing of the path keeps the limits: {} times a limit after {} rounds. Plan again.':
    'keine Zeitplanung des Weges hält die Grenzen ein: {}-fache Grenze nach {} Durchgängen. Planen Sie neu.',
  'the robot stands with {} {} m from {} (limit {} m). Clear the cell.':
    'der Roboter steht mit {} {} m von {} (Grenze {} m). Räumen Sie die Zelle.',
  'the timed path comes {} m too close ({}) where its corners are rounded. Plan again with another seed, or give the path more room.':
    'der Weg kommt {} m zu nahe ({}), wo seine Ecken gerundet sind. Planen Sie neu mit einem anderen Startwert, oder geben Sie ihm mehr Platz.',
  'a second look at the finished plan finds {} {} m from {} (limit {} m), {} s after the beginning of {}. Plan again with another seed, or give the robot more room.':
    'ein zweiter Blick auf den fertigen Plan findet {} {} m von {} (Grenze {} m), {} s nach dem Beginn von {}. Planen Sie neu mit einem anderen Startwert, oder geben Sie dem Roboter mehr Platz.',
  'at the {} of the path a load that comes off would fall {} m into zone {}. Choose another {} configuration, reduce the payload box, or move the zone.':
    '{} des Weges: eine Last, die sich löst, fiele {} m in die Zone {}. Wählen Sie eine andere Stellung, verkleinern Sie den Hüllquader, oder verschieben Sie die Zone.',
  'a load that comes off {} s after the beginning of the path, at {} m/s, would fly {} m into zone {}. Plan again with another seed, reduce the payload box, or move the zone.':
    'eine Last, die sich {} s nach dem Beginn des Weges bei {} m/s löst, flöge {} m in die Zone {}. Planen Sie neu mit einem anderen Startwert, verkleinern Sie den Hüllquader, oder verschieben Sie die Zone.',
  'the load of {} kg is too heavy for {}: it would need {} N m (limit {} N m), {} N m of them to hold still, {} s after the beginning of {}. Take a lighter payload or another home, or correct the effort in the URDF.':
    'die Last von {} kg ist zu schwer für {}: gebraucht würden {} N m (Grenze {} N m), davon {} N m, um stillzuhalten, {} s nach dem Beginn von {}. Nehmen Sie eine leichtere Last oder eine andere Heimstellung, oder berichtigen Sie effort in der URDF.',
  'no start configuration with sensor axis {} along gravity: the load is too heavy, to hold it still {} would need {} % of its torque at least (limit {} %). Take a lighter payload, give the robot more room, or correct the effort in the URDF.':
    'keine Startstellung mit der Sensorachse {} längs der Schwerkraft: die Last ist zu schwer, um sie stillzuhalten, bräuchte {} mindestens {} % seines Drehmoments (Grenze {} %). Nehmen Sie eine leichtere Last, geben Sie dem Roboter mehr Platz, oder berichtigen Sie effort in der URDF.',
  'a second look at the finished plan finds that a load that comes off at {} m/s, {} s after the beginning of {}, would fly {} m into zone {}. Plan again with another seed, or give the robot more room.':
    'ein zweiter Blick auf den fertigen Plan findet, dass eine Last, die sich bei {} m/s löst, {} s nach dem Beginn von {}, {} m in die Zone {} flöge. Planen Sie neu mit einem anderen Startwert, oder geben Sie dem Roboter mehr Platz.',
  'a second look at the finished plan finds a corner of {} at {} m/s (limit {} m/s), {} s after the beginning of {}. Plan again with another seed.':
    'ein zweiter Blick auf den fertigen Plan findet eine Ecke von {} bei {} m/s (Grenze {} m/s), {} s nach dem Beginn von {}. Planen Sie neu mit einem anderen Startwert.',
  'the finished plan cannot be carried out in {}. Plan again with another seed.':
    'der fertige Plan lässt sich nicht ausführen: {}. Planen Sie neu mit einem anderen Startwert.',
  'transfer {}': 'Fahrt nach {}',
  'rotation {}': 'Drehung um {}',
  'wave {}': 'Schwingung bei {}',
  home: 'Heimfahrt',

  // why a run, or what was asked for, ended
  '{} was asked for by {}.': '{}, verlangt von {}.',
  'cancelled by {}.': 'zurückgenommen von {}.',
  'the run was ended.': 'der Lauf wurde beendet.',
  'the service was shut down; the robot was stopped.':
    'der Dienst wurde beendet; der Roboter wurde gestoppt.',
  'the service ended while the run was in {}; the robot was stopped. Look at the cell, then clear the run.':
    'der Dienst endete, während der Lauf in {} war; der Roboter wurde gestoppt. Sehen Sie nach der Zelle, dann quittieren Sie.',
  'what happens to the run could not be written ({}); the robot was stopped. Make room on the disk.':
    'was mit dem Lauf geschieht, ließ sich nicht schreiben ({}); der Roboter wurde gestoppt. Schaffen Sie Platz auf der Platte.',
  'the release could not be written, so nothing has moved; look at the database and the disk, then make a new run.':
    'die Freigabe ließ sich nicht schreiben, darum hat sich nichts bewegt; sehen Sie nach Datenbank und Platte, dann beginnen Sie einen neuen Lauf.',
  'the server is gone; the robot was stopped. Start the service and clear the run.':
    'der Dienst ist fort; der Roboter wurde gestoppt. Starten Sie den Dienst und quittieren Sie den Lauf.',
  "the run's folder could not be written ({}); the robot was stopped. Make room.":
    'der Ordner des Laufs ließ sich nicht beschreiben ({}); der Roboter wurde gestoppt. Schaffen Sie Platz.',
  'the control process ended with code {}; its robot got no more commands. See the log.':
    'die Steuerung endete mit {}; ihr Roboter bekam keine Befehle mehr. Sehen Sie im Protokoll nach.',
  'the planning process ended unexpectedly; start a new run.':
    'die Planung endete unerwartet; beginnen Sie einen neuen Lauf.',
  "the process that did it ended unexpectedly; ask for it again. The service's log may know more.":
    'die Rechnung endete unerwartet; fordern Sie sie noch einmal an. Das Protokoll des Dienstes weiß vielleicht mehr.',

  // what does not go with the present state
  '{}: there is none called {}. List what there is and ask again.': '{}: keines heißt {}.',
  run: 'Lauf',
  cell: 'Zelle',
  'zone of cell {}': 'Zone der Zelle {}',
  diagnosis: 'Diagnose',
  trials: 'Versuche',
  addition: 'Ergänzung',
  'effect in the twin': 'Effekt im Zwilling',
  account: 'Konto',
  key: 'Schlüssel',
  webhook: 'Webhook',
  'kind of problem': 'Art von Fehler',
  'file of the console': 'Datei der Konsole',
  waiting: 'wartend',
  running: 'in Arbeit',
  done: 'fertig',
  failed: 'gescheitert',
  cancelled: 'zurückgenommen',
  '{} is not possible in {}; legal commands here: {}.': '{} ist in {} nicht möglich; hier gehen: {}.',
  'run {}: {} is not possible in {}; legal commands here: {}':
    'Lauf {}: {} ist in {} nicht möglich; hier gehen: {}',
  'run {}: there is no plan yet, it is in {}; wait until it is Idle':
    'Lauf {}: es gibt noch keinen Plan, er ist in {}; warten Sie, bis er bereit ist',
  'run {}: there is no result, it is in {}': 'Lauf {}: es gibt kein Ergebnis, er ist in {}',
  'run {}: there is no result, it is in {} ({})': 'Lauf {}: es gibt kein Ergebnis, er ist in {} ({})',
  'run {}: was accepted already, by {}; a result is accepted once':
    'Lauf {}: wurde schon angenommen, von {}; ein Ergebnis wird einmal angenommen',
  'run {}: has no recording, it is in {}; wait for its end':
    'Lauf {}: hat keine Aufzeichnung, er ist in {}; warten Sie auf sein Ende',
  'run {}: has no recording, it is in {}; one is there once a robot that has moved stands again':
    'Lauf {}: hat keine Aufzeichnung, er ist in {}; sie ist da, sobald ein Roboter, der sich bewegt hat, wieder steht',
  'run {}: has no report, it is in {}; a report comes with a run that is Complete':
    'Lauf {}: hat keinen Bericht, er ist in {}; ein Bericht kommt mit einem Lauf, der fertig ist',
  'diagnosis {}: has no report, it is {}; a report comes with a diagnosis that is done':
    'Diagnose {}: hat keinen Bericht, sie ist {}; ein Bericht kommt mit einer fertigen Diagnose',
  'run {}: its control process still closes the recording; ask again in some seconds':
    'Lauf {}: seine Steuerung schließt noch die Aufzeichnung; versuchen Sie es in einigen Sekunden noch einmal',
  'run {}: there is nothing to go on with; it is in {} and has finished {} steps. Begin a new run':
    'Lauf {}: es gibt nichts fortzusetzen; er ist in {} und hat {} Schritte fertig. Beginnen Sie einen neuen Lauf',
  'run {}: its recording is not there (yet); ask again in some seconds, or begin a new run':
    'Lauf {}: seine Aufzeichnung ist (noch) nicht da; versuchen Sie es in einigen Sekunden noch einmal, oder beginnen Sie einen neuen Lauf',
  'run {}: the database does not have its result yet; accept it again in some seconds':
    'Lauf {}: die Datenbank hat sein Ergebnis noch nicht; nehmen Sie es in einigen Sekunden noch einmal an',
  'cell {}: no run has its robot, so there is nothing to stop':
    'Zelle {}: kein Lauf hat ihren Roboter, also gibt es nichts zu stoppen',
  'cell {}: does not say how its sensor is mounted (sensor.mount), so runs of two cells have no frame in common':
    'Zelle {}: sagt nicht, wie ihr Sensor angebracht ist (sensor.mount); Läufe zweier Zellen haben so keinen gemeinsamen Rahmen',
  'control of cell {}: {} has it; ask them to let go of it':
    'Bedienung der Zelle {}: {} hat sie; bitten Sie darum, sie abzugeben',
  'control of cell {}: nobody has it; take control (POST /api/control) and answer its stamps':
    'Bedienung der Zelle {}: niemand hat sie; übernehmen Sie sie',
  'control of cell {}: {} has it with fence {}, not {} with {}':
    'Bedienung der Zelle {}: {} hat sie mit der Nummer {}, nicht {} mit {}',
  'command number {}: not above the last one, {}; it is repeated or out of order':
    'Befehl Nummer {}: nicht über dem letzten, {}; er ist wiederholt oder kam zu spät',
  'command stamp: {} s old (0 to {} s allowed); send the newest stamp you got':
    'Befehl: {} s alt (0 bis {} s erlaubt); versuchen Sie es noch einmal',
  'command {}: needs control of cell {}; send `sent` with your fence, number and stamp':
    'Befehl {}: braucht die Bedienung der Zelle {}; übernehmen Sie sie',
  'plan {}: void, the plan or the cell has changed since; look at the plan again (GET plan)':
    'Plan {}: gilt nicht mehr, Plan oder Zelle haben sich geändert; sehen Sie ihn noch einmal an',
  'resume: the database is locked, full or away, and nothing begins to move without it; resume when it is back':
    'Fortsetzen: Die Datenbank ist gesperrt, voll oder nicht erreichbar, und ohne sie beginnt keine Bewegung; setzen Sie fort, wenn sie wieder da ist',
  'release: the database is locked, full or away, and nothing moves without it; release again when it is back':
    'Freigabe: die Datenbank ist gesperrt, voll oder fort, und ohne sie bewegt sich nichts; geben Sie noch einmal frei, wenn sie wieder da ist',
  'release: the database did not take it, so nothing moves; the run was ended':
    'Freigabe: die Datenbank nahm sie nicht an, darum bewegt sich nichts; der Lauf wurde beendet',
  'disk: {} MB are free where runs are recorded, this one needs up to {} MB; make room, then release it again':
    'Platte: {} MB sind frei, wo Läufe aufgezeichnet werden, dieser braucht bis zu {} MB; schaffen Sie Platz und geben Sie dann noch einmal frei',
  'offer: not made for this plan by this service; look at the plan again (GET plan) and release what it shows':
    'Freigabe: nicht für diesen Plan gemacht; sehen Sie ihn noch einmal an und geben Sie frei, was er zeigt',
  'offer: {} s old (limit {} s); look at the plan again and release what it shows':
    'Freigabe: {} s alt (Grenze {} s); sehen Sie den Plan noch einmal an und geben Sie frei, was er zeigt',
  '{} {}: it is {}; only what waits or runs can be cancelled':
    '{} {}: ist {}; nur was wartet oder läuft, lässt sich zurücknehmen',
  'diagnosis {}': 'Diagnose {}',
  'diagnosis {}: cell {} has changed since the recording':
    'Diagnose {}: die Zelle {} hat sich seit der Aufzeichnung geändert',
  'diagnosis {}: has nothing to overlay, it is {}; a done one has, if there was enough to compare':
    'Diagnose {}: hat nichts übereinander zu legen, sie ist {}; eine fertige hat es, wenn es genug zu vergleichen gab',
  'diagnosis {}: is {}; an effect can be taken from one that is done':
    'Diagnose {}: ist {}; ein Effekt lässt sich aus einer fertigen übernehmen',
  'diagnosis {}: its recording was made in no cell of this service; upload it again with ?cell=':
    'Diagnose {}: ihre Aufzeichnung entstand in keiner Zelle dieses Dienstes; laden Sie sie noch einmal hoch und wählen Sie die Zelle',
  '{}: its recording is gone; diagnose another run':
    '{}: ihre Aufzeichnung ist fort; untersuchen Sie einen anderen Lauf',
  '{}: payload {} is none that cell {} knows; make a run with one it knows':
    '{}: die Last {} kennt die Zelle {} nicht; machen Sie einen Lauf mit einer, die sie kennt',
  'without a name': 'ohne Namen',
  '{}: was made with payload {}, not with {}; put {} back on':
    '{}: entstand mit der Last {}, nicht mit {}; bringen Sie {} wieder an',
  '{}: is {}; only one that is done proposes a motion':
    '{}: ist {}; nur eine fertige schlägt eine Bewegung vor',
  '{}: proposes no motion; it leaves nothing open that one could settle':
    '{}: schlägt keine Bewegung vor; sie lässt nichts offen, was eine klären könnte',
  '{}: asks for no motion but for {}': '{}: verlangt keine Bewegung, sondern {}',
  '{}: its motion was not planned ({}); diagnose the recording again, in a cell that leaves room':
    '{}: ihre Bewegung wurde nicht geplant ({}); untersuchen Sie die Aufzeichnung noch einmal in einer Zelle, die Platz lässt',
  '{}: it has another robot; make a new run there':
    '{}: sie hat einen anderen Roboter; machen Sie dort einen neuen Lauf',
  '{}: gravity at the base is {} m/s2, it was {}; make a new run there':
    '{}: die Schwerkraft an der Basis ist {} m/s², sie war {}; machen Sie dort einen neuen Lauf',
  'effect: found {}, expected an effect that a twin can take':
    'Effekt: gefunden: {}, erwartet: ein Effekt, den ein Zwilling aufnehmen kann',
  'a diagnosis that does not say whether a twin can take it':
    'eine Diagnose, die nicht sagt, ob ein Zwilling ihn aufnehmen kann',
  'effect: found {}, expected one that the diagnosis names: {}':
    'Effekt: gefunden: {}, erwartet: einer, den die Diagnose nennt: {}',
  'it names none': 'sie nennt keinen',
  'twin of {}: addition {} is under way; wait for its end':
    'Zwilling von {}: die Ergänzung {} läuft noch; warten Sie auf ihr Ende',
  'twin of {}: nothing was changed; send it again':
    'Zwilling von {}: nichts wurde geändert; senden Sie es noch einmal',
  'cell {} exists already; PUT /api/cells/{} replaces it': 'die Zelle {} gibt es schon',
  'upload: the cell calls itself {}, not {}; send it to /api/cells/{}':
    'hochgeladene Datei: die Zelle nennt sich {}, nicht {}',
  'upload: the process that checks cells ended; nothing was changed, send it again':
    'hochgeladene Datei: die Prüfung endete unerwartet; nichts wurde geändert, senden Sie sie noch einmal',
  "zone {}: is where the cell's file has it; there is nothing to undo":
    'Zone {}: steht, wo die Datei der Zelle sie hat; es gibt nichts zurückzunehmen',
  'zone {}: has moved {} times, not {}; look where it is now and ask again':
    'Zone {}: wurde {}-mal verschoben, nicht {}-mal; sehen Sie nach, wo sie jetzt ist, und fragen Sie noch einmal',
  'zones of {}: nothing was looked at; send it again':
    'Zonen von {}: Es wurde nichts geprüft; senden Sie die Anfrage noch einmal',
  'zone {}: measured at {}, but its place at {} is known already; send measurements in order':
    'Zone {}: gemessen um {}, aber ihr Ort um {} ist schon bekannt; senden Sie Messungen der Reihe nach',
  "measured_at: {} is ahead of the service's clock, {}; set the measuring clock":
    'Zeit der Messung: {} liegt vor der Uhr des Dienstes, {}; stellen Sie die Uhr der Messung',
  'Idempotency-Key {}: the first request is still under way; ask again':
    'Idempotency-Key {}: die erste Anfrage läuft noch; versuchen Sie es noch einmal',
  'Idempotency-Key {}: was used for another body already; take a new key for a new request':
    'Idempotency-Key {}: wurde schon für etwas anderes gebraucht; nehmen Sie für eine neue Anfrage einen neuen',
  "Content-Type: found {}, expected application/zip; send a zip of the {}'s folder":
    'Content-Type: gefunden: {}, erwartet: application/zip',

  // any request
  "the database is locked, full or away; nothing was changed. Try again; if it stays so, see the service's log":
    'die Datenbank ist gesperrt, voll oder fort; nichts wurde geändert. Versuchen Sie es noch einmal; bleibt es so, sehen Sie im Protokoll des Dienstes nach',
  "an error that was not foreseen; the service's log has it under request_id":
    'ein unvorhergesehener Fehler; das Protokoll des Dienstes hat ihn',
  '{}: there is nothing at this address; GET /openapi.json lists what there is':
    '{}: unter dieser Adresse gibt es nichts',
  '{}: this address does not know the method; see `allowed`': '{}: das geht unter dieser Adresse nicht',
  '{}: the body is too large; send a smaller one': '{}: das ist zu groß; senden Sie weniger',

  // people
  'name or password: not right; try again or ask whoever keeps the accounts':
    'Name oder Passwort: nicht richtig; versuchen Sie es noch einmal, oder fragen Sie, wer die Konten führt',
  'sign-in: too many failures of late; try again in {} s':
    'Anmeldung: zuletzt zu viele Fehlversuche; versuchen Sie es in {} s noch einmal',
  'session: ended or expired; sign in again': 'Sitzung: beendet oder abgelaufen; melden Sie sich neu an',
  'password: not the one until now': 'Passwort: nicht das bisherige',
  'password: a key has none; only an account changes its password':
    'Passwort: ein Schlüssel hat keines; nur ein Konto ändert seines',
  'key: unknown, expired or revoked; ask whoever keeps the accounts for a new one':
    'Schlüssel: unbekannt, abgelaufen oder widerrufen; bitten Sie um einen neuen, wer die Konten führt',
  'key {} exists already; revoke it or choose another name':
    'den Schlüssel {} gibt es schon; widerrufen Sie ihn, oder wählen Sie einen anderen Namen',
  'account {} exists already; choose another name or change that one':
    'das Konto {} gibt es schon; wählen Sie einen anderen Namen, oder ändern Sie jenes',
  'account {} is the last admin who can sign in; make another one first':
    'das Konto {} ist der letzte Verwalter, der sich anmelden kann; legen Sie erst einen anderen an',
  'role: found {}, expected one of {}: a machine neither releases motion nor makes accounts':
    'Rolle: gefunden: {}, erwartet: eine von {}: eine Maschine gibt keine Bewegung frei und legt keine Konten an',
  '{}: {} is {}; it takes one of {}': '{}: {} ist {}; nötig ist eines von {}',
  'no role': 'ohne Rolle',
  '{}: sign in with POST /api/session, or send a key as `Authorization: Bearer`': '{}: melden Sie sich an',
  '{}: not in the table of authority, so nobody may call it': '{}: niemandem erlaubt',
  "{}: not the session's; GET /api/session tells it": '{}: nicht das der Sitzung; laden Sie die Seite neu',
  'origin: {} is no page of this service; set HEFT_ORIGINS if it is to be one':
    'Herkunft: {} ist keine Seite dieses Dienstes; setzen Sie HEFT_ORIGINS, wenn sie eine sein soll',
  "origin: a browser's websocket has to say which page it belongs to":
    'Herkunft: der Browser muss sagen, zu welcher Seite er gehört',
};
