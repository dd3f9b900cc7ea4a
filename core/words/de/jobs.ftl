# Die Wörter für Arten von Aufträgen und wie weit sie sind, für andere Meldungen.
jobs-kind = { $kind ->
    [diagnosis] Diagnose
    [trials] Versuche
   *[other] { $kind }
}
jobs-state = { $state ->
    [waiting] wartend
    [running] in Arbeit
    [done] fertig
    [failed] gescheitert
    [cancelled] zurückgenommen
   *[other] { $state }
}

jobs-work-lost = die Rechnung endete unerwartet; fordern Sie sie noch einmal an. Das Protokoll des Dienstes weiß vielleicht mehr.
jobs-unknown = { jobs-kind }: es gibt keine mit dem Namen „{ $job }“. Sehen Sie nach, welche es gibt, und versuchen Sie es noch einmal.
jobs-over = { jobs-kind } { $job }: ist { jobs-state }; nur was wartet oder läuft, lässt sich zurücknehmen

# Was eine Diagnose hinterlässt, und die Bewegung, die sie vorschlägt.
jobs-no-overlay = Diagnose { $job }: hat nichts übereinander zu legen, sie ist { jobs-state }; eine fertige hat es, wenn es genug zu vergleichen gab
jobs-no-report = Diagnose { $job }: hat keinen Bericht, sie ist { jobs-state }; ein Bericht kommt mit einer fertigen Diagnose
jobs-no-cell = Diagnose { $job }: ihre Aufzeichnung entstand in keiner Zelle dieses Dienstes; laden Sie sie noch einmal hoch und wählen Sie die Zelle
jobs-upload-of-other-cell = Diese Aufzeichnung stammt aus der Zelle „{ $found }“, nicht aus „{ $cell }“. Wählen Sie jene Zelle oder „Anderer Roboter“.
jobs-upload-of-other-robot = Diese Aufzeichnung stammt von einem anderen Roboter als dem der Zelle „{ $cell }“. Wählen Sie „Anderer Roboter“: Sie wird ohne den Zwilling dieser Zelle untersucht.
jobs-recording-gone = Diagnose { $job }: ihre Aufzeichnung ist fort; untersuchen Sie einen anderen Lauf
jobs-payload-unknown = Diagnose { $job }: die Last „{ $payload }“ kennt die Zelle „{ $cell }“ nicht; machen Sie einen Lauf mit einer, die sie kennt
jobs-payload-unnamed = Diagnose { $job }: ihre Last hat keinen Namen, also kennt die Zelle „{ $cell }“ sie nicht; machen Sie einen Lauf mit einer, die sie kennt
jobs-payload-differs = Diagnose { $job }: entstand mit der Last „{ $payload }“, nicht mit „{ $given_payload }“; bringen Sie „{ $payload }“ wieder an
jobs-no-motion-yet = Diagnose { $job }: ist { jobs-state }; nur eine fertige schlägt eine Bewegung vor
jobs-no-motion-proposed = Diagnose { $job }: schlägt keine Bewegung vor; sie lässt nichts offen, was eine klären könnte
jobs-no-motion-asked = Diagnose { $job }: verlangt keine Bewegung, sondern { $motion }
jobs-motion-refused = Diagnose { $job }: ihre Bewegung wurde nicht geplant ({ $refusal }); untersuchen Sie die Aufzeichnung noch einmal in einer Zelle, die Platz lässt
jobs-motion-not-planned = Diagnose { $job }: ihre Bewegung wurde nicht geplant; untersuchen Sie die Aufzeichnung noch einmal in einer Zelle, die Platz lässt
jobs-robot-changed = Diagnose { $job }: die Zelle „{ $cell }“ hat sich seit der Aufzeichnung geändert: sie hat einen anderen Roboter; machen Sie dort einen neuen Lauf
jobs-gravity-changed = Diagnose { $job }: die Zelle „{ $cell }“ hat sich seit der Aufzeichnung geändert: die Schwerkraft an der Basis ist ({ $gravity_m_s2 }) m/s², sie war ({ $recorded_m_s2 }); machen Sie dort einen neuen Lauf

# Die Zwillinge.
jobs-effect-not-in-twin = Effekt im Zwilling: keiner heißt „{ $effect }“. Sehen Sie nach, welche es gibt, und versuchen Sie es noch einmal.
jobs-no-effect-yet = Diagnose { $job }: ist { jobs-state }; ein Effekt lässt sich aus einer fertigen übernehmen
