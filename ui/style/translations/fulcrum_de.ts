<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>PracticeView</name>
    <message>
        <source>d MMM</source>
        <translation>d. MMM</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Up</source>
        <translation>Hoch</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Runter</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>PgUp</source>
        <translation>Bild auf</translation>
    </message>
    <message>
        <source>PgDown</source>
        <translation>Bild ab</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Pos1</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Rücktaste</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Entf</translation>
    </message>
    <message>
        <source>Ins</source>
        <translation>Einfg</translation>
    </message>
</context>
<context>
    <name>RemoteTrace</name>
    <message>
        <source>Fetching the recording from the programme server …</source>
        <translation>Die Aufzeichnung wird vom Programmserver geholt …</translation>
    </message>
</context>
<context>
    <name>commands</name>
    <message>
        <source>Print this help and exit.</source>
        <translation>Diese Hilfe ausgeben und beenden.</translation>
    </message>
    <message>
        <source>fulcrum %1 [options]</source>
        <translation>fulcrum %1 [Optionen]</translation>
    </message>
    <message>
        <source>fulcrum %1 %2 [options]</source>
        <translation>fulcrum %1 %2 [Optionen]</translation>
    </message>
    <message>
        <source>Prints a completion script for bash or zsh.</source>
        <translation>Gibt ein Skript aus, mit dem bash oder zsh Befehle ergänzt.</translation>
    </message>
    <message>
        <source>For bash: fulcrum completion bash &gt; ~/.local/share/bash-completion/completions/fulcrum</source>
        <translation>Für bash: fulcrum completion bash &gt; ~/.local/share/bash-completion/completions/fulcrum</translation>
    </message>
    <message>
        <source>Prints what the commands do, or one command&apos;s options.</source>
        <translation>Gibt aus, was die Befehle tun, oder die Optionen eines Befehls.</translation>
    </message>
    <message>
        <source>Prints the manual page.</source>
        <translation>Gibt die Handbuchseite aus.</translation>
    </message>
    <message>
        <source>To read it: fulcrum manual &gt; fulcrum.1; man ./fulcrum.1</source>
        <translation>Um sie zu lesen: fulcrum manual &gt; fulcrum.1; man ./fulcrum.1</translation>
    </message>
    <message>
        <source>Lists the installed scenes, tasks, benchmark sets and curricula, and which of them assessed attempts accept.</source>
        <translation>Listet die installierten Szenen, Aufgaben, Richtwertsätze und Curricula auf und nennt, welche davon für bewertete Versuche zugelassen sind.</translation>
    </message>
    <message>
        <source>Accepts a file of the site, such as a benchmark set from its experts, for assessed attempts.</source>
        <translation>Lässt eine Datei des Standorts, etwa einen Richtwertsatz seiner Experten, für bewertete Versuche zu.</translation>
    </message>
    <message>
        <source>The reason; recorded in the audit log.</source>
        <translation>Der Grund; er wird im Protokoll gespeichert.</translation>
    </message>
    <message>
        <source>Builds a benchmark set and prints the share of its own experts&apos; attempts that would pass.</source>
        <translation>Erstellt einen Richtwertsatz und gibt aus, welcher Anteil der Versuche seiner eigenen Experten bestehen würde.</translation>
    </message>
    <message>
        <source>Use synthetic operators; the set is provisional.</source>
        <translation>Simulierte Operateure verwenden; der Satz ist vorläufig.</translation>
    </message>
    <message>
        <source>Use the stored attempts of these people; needs --as. The set takes over the task&apos;s provisional limits; one of simulated people is provisional.</source>
        <translation>Die gespeicherten Versuche dieser Personen verwenden; braucht --as. Der Satz übernimmt die vorläufigen Grenzwerte der Aufgabe; einer von simulierten Personen ist vorläufig.</translation>
    </message>
    <message>
        <source>The class of devices that the set is for; operators work through a model of it.</source>
        <translation>Die Geräteklasse, für die der Satz gilt; die Operateure arbeiten mit einem Modell davon.</translation>
    </message>
    <message>
        <source>Build the sets of all tasks and device classes, from operators.</source>
        <translation>Die Sätze aller Aufgaben und Geräteklassen mit simulierten Operateuren erstellen.</translation>
    </message>
    <message>
        <source>Write the set to this file; with --all, the sets to this folder. The version of a set is one more than that of the one it replaces.</source>
        <translation>Den Satz in diese Datei schreiben; mit --all die Sätze in diesen Ordner. Die Version eines Satzes ist um eins höher als die des Satzes, den er ersetzt.</translation>
    </message>
    <message>
        <source>Lists the installed versions of the curriculum; with --db also how many people follow each.</source>
        <translation>Listet die installierten Versionen des Curriculums auf; mit --db auch, wie viele Personen nach jeder lernen.</translation>
    </message>
    <message>
        <source>Moves a person or a cohort to another version of the curriculum; needs --as.</source>
        <translation>Stellt eine Person oder eine Gruppe auf eine andere Version des Curriculums um; braucht --as.</translation>
    </message>
    <message>
        <source>Move this person.</source>
        <translation>Diese Person umstellen.</translation>
    </message>
    <message>
        <source>Move everybody in this cohort.</source>
        <translation>Alle Personen dieser Gruppe umstellen.</translation>
    </message>
    <message>
        <source>Print which standings would change and move nobody.</source>
        <translation>Ausgeben, welcher Stand sich ändern würde, und niemanden umstellen.</translation>
    </message>
    <message>
        <source>Why; kept in the audit log.</source>
        <translation>Der Grund; er wird im Protokoll gespeichert.</translation>
    </message>
    <message>
        <source>Prints how likely a rule declares a trainee proficient who passes each attempt with the same chance. Learning and the condition of two days are left out.</source>
        <translation>Gibt aus, mit welcher Wahrscheinlichkeit eine Regel eine Aufgabe für sicher beherrscht erklärt, wenn jeder Versuch mit derselben Wahrscheinlichkeit bestanden wird. Lernen und die Bedingung zweier Tage sind nicht berücksichtigt.</translation>
    </message>
    <message>
        <source>row:K, of:K,N or lc-cusum:P0,P1,H.</source>
        <translation>row:K, of:K,N oder lc-cusum:P0,P1,H.</translation>
    </message>
    <message>
        <source>The chance of a pass, from 0 to 1.</source>
        <translation>Die Wahrscheinlichkeit zu bestehen, von 0 bis 1.</translation>
    </message>
    <message>
        <source>The number of attempts, from 1 to 1000.</source>
        <translation>Die Zahl der Versuche, von 1 bis 1000.</translation>
    </message>
    <message>
        <source>Fits learning curves to the values of attempts 1, 2, 3, ...: columns x and y.</source>
        <translation>Passt Lernkurven an die Werte der Versuche 1, 2, 3, ... an: Spalten x und y.</translation>
    </message>
    <message>
        <source>Prints how far raters agree: columns target, rater and score.</source>
        <translation>Gibt aus, wie weit Beurteiler übereinstimmen: Spalten target, rater und score.</translation>
    </message>
    <message>
        <source>Prints mean and standard deviation of experts as a benchmark set uses them: columns expert and value.</source>
        <translation>Gibt Mittelwert und Standardabweichung von Experten aus, wie ein Richtwertsatz sie verwendet: Spalten expert und value.</translation>
    </message>
    <message>
        <source>The scale of the values.</source>
        <translation>Die Skala der Werte.</translation>
    </message>
    <message>
        <source>Computes the metrics of a trace in the CSV format of docs/FORMATS.md; - reads standard input. With its events it also gives gates, pathology and verdict.</source>
        <translation>Berechnet die Kennzahlen einer Aufzeichnung im CSV-Format von docs/FORMATS.md; - liest die Standardeingabe. Mit ihren Ereignissen auch Kriterien, Pathologie und Ergebnis.</translation>
    </message>
    <message>
        <source>The trace is of another program: which of its columns is which, and in which unit. Examples are in assets/mappings.</source>
        <translation>Die Aufzeichnung stammt von einem anderen Programm: welche ihrer Spalten was enthält und in welcher Einheit. Beispiele sind in assets/mappings.</translation>
    </message>
    <message>
        <source>The task that the trace belongs to; metrics that depend on its targets need it.</source>
        <translation>Die Aufgabe, zu der die Aufzeichnung gehört; Kennzahlen, die von ihren Zielen abhängen, brauchen sie.</translation>
    </message>
    <message>
        <source>The attempt&apos;s events.</source>
        <translation>Die Ereignisse des Versuchs.</translation>
    </message>
    <message>
        <source>The class of the device; its limits are used.</source>
        <translation>Die Geräteklasse; ihre Grenzwerte gelten.</translation>
    </message>
    <message>
        <source>The fidelity of the simulation; its limits are used.</source>
        <translation>Die Genauigkeit der Simulation; ihre Grenzwerte gelten.</translation>
    </message>
    <message>
        <source>the scene&apos;s own</source>
        <translation>die der Szene</translation>
    </message>
    <message>
        <source>Checks scenes, tasks, curricula, benchmark sets, observer forms, mappings and traces; - reads standard input.</source>
        <translation>Prüft Szenen, Aufgaben, Curricula, Richtwertsätze, Beurteilungsbögen, Zuordnungen und Aufzeichnungen; - liest die Standardeingabe.</translation>
    </message>
    <message>
        <source>Only entries about this person.</source>
        <translation>Nur Einträge zu dieser Person.</translation>
    </message>
    <message>
        <source>Creates an empty store.</source>
        <translation>Legt einen leeren Datenbestand an.</translation>
    </message>
    <message>
        <source>Checks that the store is complete and unchanged.</source>
        <translation>Prüft, ob der Datenbestand vollständig und unverändert ist.</translation>
    </message>
    <message>
        <source>Also check that the audit log contains this head, which a report or `db audit` printed earlier: 16 to 64 hexadecimal digits.</source>
        <translation>Auch prüfen, ob das Protokoll diesen Kopf enthält, den ein Bericht oder `db audit` früher genannt hat: 16 bis 64 Hexadezimalziffern.</translation>
    </message>
    <message>
        <source>Puts a backup in the store&apos;s place, after checking it; the old store is kept.</source>
        <translation>Setzt eine Sicherung nach einer Prüfung an die Stelle des Datenbestands; der alte bleibt erhalten.</translation>
    </message>
    <message>
        <source>Brings an older store up to this program&apos;s schema, after checking it; the old file is kept.</source>
        <translation>Bringt einen älteren Datenbestand nach einer Prüfung auf das Schema dieser Software; die alte Datei bleibt erhalten.</translation>
    </message>
    <message>
        <source>Lists the audit log and checks its chain.</source>
        <translation>Listet das Protokoll auf und prüft seine Kette.</translation>
    </message>
    <message>
        <source>Only entries of this operation, or of the group before its dot.</source>
        <translation>Nur Einträge dieses Vorgangs oder der Gruppe vor seinem Punkt.</translation>
    </message>
    <message>
        <source>From this day (2026-11-21) or time (2026-11-21T04:07:37Z), UTC.</source>
        <translation>Ab diesem Tag (2026-11-21) oder Zeitpunkt (2026-11-21T04:07:37Z), UTC.</translation>
    </message>
    <message>
        <source>Up to this day or time, UTC.</source>
        <translation>Bis zu diesem Tag oder Zeitpunkt, UTC.</translation>
    </message>
    <message>
        <source>Show at most this many of the newest entries.</source>
        <translation>Höchstens so viele der neuesten Einträge zeigen.</translation>
    </message>
    <message>
        <source>Scores interrupted attempts that have no score yet.</source>
        <translation>Bewertet unterbrochene Versuche, die noch keine Bewertung haben.</translation>
    </message>
    <message>
        <source>Recomputes outdated scores; the scores in force stay unchanged.</source>
        <translation>Berechnet veraltete Bewertungen neu; die geltenden Bewertungen bleiben unverändert.</translation>
    </message>
    <message>
        <source>Lists the installed observer forms with their items; fulcrum check FILE checks one.</source>
        <translation>Listet die installierten Beurteilungsbögen mit ihren Punkten auf; fulcrum check DATEI prüft einen.</translation>
    </message>
    <message>
        <source>note: %1 was not written: the recording has not all events of an attempt, from its begin to its end</source>
        <translation>Hinweis: %1 wurde nicht geschrieben: Die Aufnahme hat nicht alle Ereignisse eines Versuchs von seinem Anfang bis zu seinem Ende</translation>
    </message>
    <message>
        <source>Sends a stored attempt over OpenIGTLink, for example to 3D Slicer, as soon as a program connects.</source>
        <translation>Sendet einen gespeicherten Versuch über OpenIGTLink, zum Beispiel an 3D Slicer, sobald sich ein Programm verbindet.</translation>
    </message>
    <message>
        <source>Where to listen. Without it other computers cannot connect.</source>
        <translation>Wo auf Verbindungen gewartet wird. Ohne diese Angabe können sich andere Computer nicht verbinden.</translation>
    </message>
    <message>
        <source>Frames a second, 1 to 1000.</source>
        <translation>Bilder je Sekunde, 1 bis 1000.</translation>
    </message>
    <message>
        <source>How many times as fast as it was performed, 1 to 1000.</source>
        <translation>Wievielfach so schnell wie bei der Durchführung, 1 bis 1000.</translation>
    </message>
    <message>
        <source>Each frame has a TRANSFORM for each tool (LeftTipToPatient, RightTipToPatient, CameraToPatient; mm, axes of 3D Slicer), the force of each instrument on tissue (SENSOR LeftForce, RightForce; N) and its state (LeftState, RightState). Events are STRINGs. docs/FORMATS.md has the details.</source>
        <translation>Jedes Bild hat ein TRANSFORM für jedes Werkzeug (LeftTipToPatient, RightTipToPatient, CameraToPatient; mm, Achsen von 3D Slicer), die Kraft jedes Instruments auf Gewebe (SENSOR LeftForce, RightForce; N) und seinen Zustand (LeftState, RightState). Ereignisse sind STRINGs. Die Einzelheiten sind in docs/FORMATS.md.</translation>
    </message>
    <message>
        <source>Records what an OpenIGTLink server sends as a trace in the CSV format of docs/FORMATS.md.</source>
        <translation>Nimmt auf, was ein OpenIGTLink-Server sendet, als Aufzeichnung im CSV-Format von docs/FORMATS.md.</translation>
    </message>
    <message>
        <source>The file to write.</source>
        <translation>Die Datei, die geschrieben wird.</translation>
    </message>
    <message>
        <source>Also write the events, where Fulcrum sends a whole attempt.</source>
        <translation>Auch die Ereignisse schreiben, wo Fulcrum einen ganzen Versuch sendet.</translation>
    </message>
    <message>
        <source>The tool of the left hand.</source>
        <translation>Das Werkzeug der linken Hand.</translation>
    </message>
    <message>
        <source>The tool of the right hand.</source>
        <translation>Das Werkzeug der rechten Hand.</translation>
    </message>
    <message>
        <source>The tool of the scope.</source>
        <translation>Das Werkzeug der Optik.</translation>
    </message>
    <message>
        <source>Stop after this time, 1 to 7200.</source>
        <translation>Nach dieser Zeit aufhören, 1 bis 7200.</translation>
    </message>
    <message>
        <source>until the attempt ends, or Ctrl-C</source>
        <translation>bis der Versuch endet, oder Strg-C</translation>
    </message>
    <message>
        <source>Stores a trace that was recorded elsewhere (box trainer, robot, another simulator) as an external attempt of a person: measured, judged by no limits, never part of a standing.</source>
        <translation>Speichert eine Aufzeichnung, die anderswo entstand (Boxtrainer, Roboter, anderer Simulator), als externen Versuch einer Person: gemessen, an keinen Grenzwerten geprüft, nie Teil eines Stands.</translation>
    </message>
    <message>
        <source>Which column of the trace is which, and in which unit; without it the trace is in the format of docs/FORMATS.md. Examples are in assets/mappings.</source>
        <translation>Welche Spalte der Aufzeichnung was enthält und in welcher Einheit; ohne diese Angabe hat die Aufzeichnung das Format von docs/FORMATS.md. Beispiele sind in assets/mappings.</translation>
    </message>
    <message>
        <source>What was performed: letters, digits, dots, hyphens, underscores.</source>
        <translation>Was durchgeführt wurde: Buchstaben, Ziffern, Punkte, Bindestriche, Unterstriche.</translation>
    </message>
    <message>
        <source>Who performed it: with --as a person of a cohort of that educator, else an external person of this station, created if missing (external-NAME).</source>
        <translation>Wer ihn durchgeführt hat: mit --as eine Person aus einer Gruppe dieses Ausbilders, sonst eine externe Person dieser Station, die angelegt wird, wenn es sie nicht gibt (external-NAME).</translation>
    </message>
    <message>
        <source>When, in local time: 2026-11-20T14:05.</source>
        <translation>Wann, in Ortszeit: 2026-11-20T14:05.</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>What recorded it.</source>
        <translation>Womit aufgezeichnet wurde.</translation>
    </message>
    <message>
        <source>the title of the mapping</source>
        <translation>der Titel der Zuordnung</translation>
    </message>
    <message>
        <source>Read, measure and check, but store nothing.</source>
        <translation>Lesen, messen und prüfen, aber nichts speichern.</translation>
    </message>
    <message>
        <source>Why; stored in the audit log.</source>
        <translation>Der Grund; er wird im Protokoll gespeichert.</translation>
    </message>
    <message>
        <source>Merges an account into another account of the same person; needs --as, an administrator.</source>
        <translation>Führt ein Konto mit einem anderen Konto derselben Person zusammen; braucht --as, einen Administrator.</translation>
    </message>
    <message>
        <source>Print what follows and change nothing.</source>
        <translation>Ausgeben, was folgt, und nichts ändern.</translation>
    </message>
    <message>
        <source>LOGIN is the doubled account, INTO the one that stays. Attempts with their scores, comments and ratings, goals and decisions are read as INTO&apos;s from then on, on every station and on the programme server; nothing that is signed is changed. Cohorts and drafts move. LOGIN no longer signs in, and nobody else can be given it. INTO has to hold every role that LOGIN holds.</source>
        <translation>ANMELDENAME ist das doppelte Konto, ZIEL das Konto, das bleibt. Versuche mit ihren Bewertungen, Kommentare und Beurteilungen, Ziele und Entscheidungen gehören von da an zu ZIEL, an jeder Station und auf dem Programmserver; nichts Signiertes wird geändert. Gruppen und Entwürfe ziehen um. Mit ANMELDENAME meldet sich niemand mehr an, und niemand sonst kann ihn bekommen. ZIEL muss jede Rolle haben, die ANMELDENAME hat.</translation>
    </message>
    <message>
        <source>Undoes a merge; needs --as, an administrator.</source>
        <translation>Macht das Zusammenführen rückgängig; braucht --as, einen Administrator.</translation>
    </message>
    <message>
        <source>What was done under LOGIN is its own again. The account stays deactivated; roles, cohorts and a password are given as to a new one.</source>
        <translation>Was unter ANMELDENAME geschah, gehört wieder zu diesem Konto. Es bleibt deaktiviert; Rollen, Gruppen und ein Passwort bekommt es wie ein neues.</translation>
    </message>
    <message>
        <source>%1 %2 ms of processor time for one second, the reference</source>
        <translation>%1 %2 ms Prozessorzeit für eine Sekunde, der Vergleichswert</translation>
    </message>
    <message>
        <source>%1 %2 ms of processor time for one second, the same score</source>
        <translation>%1 %2 ms Prozessorzeit für eine Sekunde, dieselbe Bewertung</translation>
    </message>
    <message>
        <source>%1 %2 ms of processor time for one second, another verdict for %3 of %4</source>
        <translation>%1 %2 ms Prozessorzeit für eine Sekunde, ein anderes Ergebnis bei %3 von %4</translation>
    </message>
    <message>
        <source>%1 %2 ms of processor time for one second, %3 %4 %, another verdict for %5 of %6</source>
        <translation>%1 %2 ms Prozessorzeit für eine Sekunde, %3 %4 %, ein anderes Ergebnis bei %5 von %6</translation>
    </message>
    <message>
        <source>What a fidelity costs in score is not measured for this version.</source>
        <translation>Wie sich die Genauigkeit auf die Bewertung auswirkt, ist für diese Version nicht gemessen.</translation>
    </message>
    <message>
        <source>Runs one attempt without a window, stores it and scores it.</source>
        <translation>Führt einen Versuch ohne Fenster durch, speichert und bewertet ihn.</translation>
    </message>
    <message>
        <source>The synthetic operator that performs.</source>
        <translation>Der simulierte Operateur, der ihn durchführt.</translation>
    </message>
    <message>
        <source>Perform the movements of a trace instead of those of an operator.</source>
        <translation>Die Bewegungen einer Aufzeichnung statt der eines simulierten Operateurs ausführen.</translation>
    </message>
    <message>
        <source>The synthetic or external person to whom the attempt belongs; created if missing.</source>
        <translation>Die synthetische oder externe Person, der der Versuch gehört; sie wird angelegt, wenn es sie nicht gibt.</translation>
    </message>
    <message>
        <source>one person for each operator and seed</source>
        <translation>eine Person für jeden Operateur und Startwert</translation>
    </message>
    <message>
        <source>The device that a trace was made with, or that an operator is to work through. A class that the task does not name is practice only.</source>
        <translation>Das Gerät, mit dem eine Aufzeichnung entstand oder mit dem ein simulierter Operateur arbeiten soll. Mit einer Klasse, die die Aufgabe nicht nennt, ist der Versuch nur Übung.</translation>
    </message>
    <message>
        <source>synthetic for an operator, external for a trace</source>
        <translation>synthetic bei einem simulierten Operateur, external bei einer Aufzeichnung</translation>
    </message>
    <message>
        <source>Perform in practice mode: measured, but not assessed.</source>
        <translation>Als Übung durchführen: gemessen, aber nicht bewertet.</translation>
    </message>
    <message>
        <source>The level of detail of the models.</source>
        <translation>Wie genau die Modelle rechnen.</translation>
    </message>
    <message>
        <source>Run in real time with the threads of the window instead of as fast as possible.</source>
        <translation>In Echtzeit mit den Threads des Fensters rechnen statt so schnell wie möglich.</translation>
    </message>
    <message>
        <source>Simulates a stored attempt again from its record.</source>
        <translation>Simuliert einen gespeicherten Versuch noch einmal aus seiner Aufzeichnung.</translation>
    </message>
    <message>
        <source>Exit with 1 if state hash, forces or metrics differ from the record.</source>
        <translation>Mit 1 enden, wenn Zustandsprüfsumme, Kräfte oder Kennzahlen von der Aufzeichnung abweichen.</translation>
    </message>
    <message>
        <source>Writes the programme&apos;s attempts for research, without names; needs --as, a director.</source>
        <translation>Schreibt die Versuche des Programms für die Forschung, ohne Namen; braucht --as, eine Programmleitung.</translation>
    </message>
    <message>
        <source>The folder to write to.</source>
        <translation>Der Zielordner.</translation>
    </message>
    <message>
        <source>Makes accounts for the people of a list; needs --as, an administrator.</source>
        <translation>Legt Konten für die Personen einer Liste an; braucht --as, einen Administrator.</translation>
    </message>
    <message>
        <source>Print what would be done and change nothing.</source>
        <translation>Ausgeben, was geschehen würde, und nichts ändern.</translation>
    </message>
    <message>
        <source>Write the one-time passwords to this new file instead of printing them; only you can read it.</source>
        <translation>Die Einmalpasswörter in diese neue Datei schreiben, statt sie auszugeben; nur Sie können sie lesen.</translation>
    </message>
    <message>
        <source>Makes the cohorts of a list and adds people to them; needs --as, a director.</source>
        <translation>Legt die Gruppen einer Liste an und fügt ihnen Personen hinzu; braucht --as, eine Programmleitung.</translation>
    </message>
    <message>
        <source>The programme server: postgresql://USER@HOST:PORT/DATABASE. The password comes from ~/.pgpass or the file named in PGPASSFILE, never from the command line.</source>
        <translation>Der Programmserver: postgresql://USER@HOST:PORT/DATABASE. Das Passwort kommt aus ~/.pgpass oder der Datei, die PGPASSFILE nennt, nie aus der Befehlszeile.</translation>
    </message>
    <message>
        <source>Exchanges people, attempts, scores and reviews with the programme server.</source>
        <translation>Tauscht Personen, Versuche, Bewertungen und Beurteilungen mit dem Programmserver aus.</translation>
    </message>
    <message>
        <source>An administrator signs in with --as; a store without people needs no sign-in for its first sync, which brings them. Can be cut off at any time (Ctrl-C too): the next sync completes it.</source>
        <translation>Ein Administrator meldet sich mit --as an; ein Datenbestand ohne Personen braucht für den ersten Abgleich, der sie bringt, keine Anmeldung. Kann jederzeit abgebrochen werden (auch mit Strg-C): Der nächste Abgleich vervollständigt ihn.</translation>
    </message>
    <message>
        <source>Makes the tables of a programme server in an empty PostgreSQL database, or upgrades them.</source>
        <translation>Legt die Tabellen eines Programmservers in einer leeren PostgreSQL-Datenbank an oder bringt sie auf den neuesten Stand.</translation>
    </message>
    <message>
        <source>Checks the audit logs of all stations on the server, their signatures, and what was signed.</source>
        <translation>Prüft die Protokolle aller Stationen auf dem Server, ihre Signaturen und was signiert wurde.</translation>
    </message>
    <message>
        <source>Makes the server&apos;s account of a person who is to look at reports and pages there, or brings its roles up to date.</source>
        <translation>Legt auf dem Server das Konto einer Person an, die dort Berichte und Seiten ansehen soll, oder bringt seine Rollen auf den neuesten Stand.</translation>
    </message>
    <message>
        <source>The account&apos;s name is the person&apos;s id. It reads what the person may see as trainee, educator or director, and changes nothing. Give it its password with psql.</source>
        <translation>Der Name des Kontos ist die Kennung der Person. Es liest, was die Person als trainee, educator oder director sehen darf, und ändert nichts. Geben Sie ihm sein Passwort mit psql.</translation>
    </message>
    <message>
        <source>Erases a person (by id) on the server; each station follows at its next sync.</source>
        <translation>Löscht eine Person (nach ihrer Kennung) auf dem Server; jede Station folgt bei ihrem nächsten Abgleich.</translation>
    </message>
    <message>
        <source>Only show what would be erased.</source>
        <translation>Nur zeigen, was gelöscht würde.</translation>
    </message>
    <message>
        <source>Shows or sets the site&apos;s cutting parameters of a task&apos;s tissues.</source>
        <translation>Zeigt oder setzt die Schnittparameter des Standorts für die Gewebe einer Aufgabe.</translation>
    </message>
    <message>
        <source>New values: TISSUE.KEY=NUMBER, separated by commas. Numbers have a decimal point.</source>
        <translation>Neue Werte: TISSUE.KEY=NUMBER, durch Kommas getrennt. Zahlen haben einen Dezimalpunkt.</translation>
    </message>
    <message>
        <source>Restore the values of the scene file.</source>
        <translation>Die Werte der Szenendatei wiederherstellen.</translation>
    </message>
    <message>
        <source>Print one JSON document on standard output.</source>
        <translation>Ein JSON-Dokument auf der Standardausgabe ausgeben.</translation>
    </message>
    <message>
        <source>The store to use; for reports also the address of a programme server, postgresql://ACCOUNT@HOST:PORT/DATABASE.</source>
        <translation>Der Datenbestand; für Berichte auch die Adresse eines Programmservers, postgresql://ACCOUNT@HOST:PORT/DATABASE.</translation>
    </message>
    <message>
        <source>the store of this user account</source>
        <translation>der Datenbestand dieses Benutzerkontos</translation>
    </message>
    <message>
        <source>The variant of the task.</source>
        <translation>Die Variante der Aufgabe.</translation>
    </message>
    <message>
        <source>The seed, from 0 to 4000000000.</source>
        <translation>Der Startwert der Zufallszahlen, von 0 bis 4000000000.</translation>
    </message>
    <message>
        <source>Sign in as this person.</source>
        <translation>Als diese Person anmelden.</translation>
    </message>
    <message>
        <source>the station, which may see synthetic people only</source>
        <translation>die Station, die nur synthetische Personen sehen darf</translation>
    </message>
    <message>
        <source>The role to act in.</source>
        <translation>Die Rolle, in der gehandelt wird.</translation>
    </message>
    <message>
        <source>the person&apos;s first role</source>
        <translation>die erste Rolle der Person</translation>
    </message>
    <message>
        <source>A file with the password on its first line.</source>
        <translation>Eine Datei mit dem Passwort in der ersten Zeile.</translation>
    </message>
    <message>
        <source>ask at the terminal</source>
        <translation>Frage am Terminal</translation>
    </message>
    <message>
        <source>One of %1.</source>
        <translation>Möglich: %1.</translation>
    </message>
    <message>
        <source>Default: %1.</source>
        <translation>Vorgabe: %1.</translation>
    </message>
    <message>
        <source>usage:</source>
        <translation>Aufruf:</translation>
    </message>
    <message>
        <source>options:</source>
        <translation>Optionen:</translation>
    </message>
    <message>
        <source>0: success. 1: the command failed, or a check found an error. 2: wrong usage or invalid input; one line on standard error says what is wrong, where, and what to do.</source>
        <translation>0: Erfolg. 1: Der Befehl schlug fehl, oder eine Prüfung fand einen Fehler. 2: falscher Aufruf oder ungültige Eingabe; eine Zeile auf der Standardfehlerausgabe sagt, was falsch ist, wo, und was zu tun ist.</translation>
    </message>
    <message>
        <source>fulcrum [--db STORE]</source>
        <translation>fulcrum [--db BESTAND]</translation>
    </message>
    <message>
        <source>the application; STORE: a file, or a programme server&apos;s address</source>
        <translation>die Anwendung; BESTAND: eine Datei oder die Adresse eines Programmservers</translation>
    </message>
    <message>
        <source>fulcrum COMMAND [options]</source>
        <translation>fulcrum BEFEHL [Optionen]</translation>
    </message>
    <message>
        <source>one command, without the window</source>
        <translation>ein Befehl, ohne das Fenster</translation>
    </message>
    <message>
        <source>commands:</source>
        <translation>Befehle:</translation>
    </message>
    <message>
        <source>fulcrum COMMAND --help shows a command&apos;s options, fulcrum --version the version.</source>
        <translation>fulcrum BEFEHL --help zeigt die Optionen eines Befehls, fulcrum --version die Version.</translation>
    </message>
    <message>
        <source>exit status:</source>
        <translation>Endstatus:</translation>
    </message>
    <message>
        <source>fulcrum %1 ACTION [options]</source>
        <translation>fulcrum %1 AKTION [Optionen]</translation>
    </message>
    <message>
        <source>actions:</source>
        <translation>Aktionen:</translation>
    </message>
    <message>
        <source>fulcrum %1 ACTION --help shows an action&apos;s options.</source>
        <translation>fulcrum %1 AKTION --help zeigt die Optionen einer Aktion.</translation>
    </message>
    <message>
        <source>User Commands</source>
        <translation>Dienstprogramme für Benutzer</translation>
    </message>
    <message>
        <source>NAME</source>
        <translation>NAME</translation>
    </message>
    <message>
        <source>trainer for laparoscopic bowel surgery</source>
        <translation>Trainer für laparoskopische Darmchirurgie</translation>
    </message>
    <message>
        <source>SYNOPSIS</source>
        <translation>ÜBERSICHT</translation>
    </message>
    <message>
        <source>[--db STORE]</source>
        <translation>[--db BESTAND]</translation>
    </message>
    <message>
        <source>[options]</source>
        <translation>[Optionen]</translation>
    </message>
    <message>
        <source>DESCRIPTION</source>
        <translation>BESCHREIBUNG</translation>
    </message>
    <message>
        <source>Without a command the window opens, with the store STORE (a file, or the address of a programme server, which is only read). With a command the program runs it without a window.</source>
        <translation>Ohne Befehl öffnet sich das Fenster, mit dem Datenbestand BESTAND (einer Datei oder der Adresse eines Programmservers, der nur gelesen wird). Mit einem Befehl führt die Software ihn ohne Fenster aus.</translation>
    </message>
    <message>
        <source>Every command that takes %1 prints one JSON document on standard output and everything else on standard error.</source>
        <translation>Jeder Befehl, der %1 kennt, gibt damit ein JSON-Dokument auf der Standardausgabe aus und alles andere auf der Standardfehlerausgabe.</translation>
    </message>
    <message>
        <source>COMMANDS</source>
        <translation>BEFEHLE</translation>
    </message>
    <message>
        <source>OPTIONS</source>
        <translation>OPTIONEN</translation>
    </message>
    <message>
        <source>Print the version and exit.</source>
        <translation>Die Version ausgeben und beenden.</translation>
    </message>
    <message>
        <source>EXIT STATUS</source>
        <translation>ENDSTATUS</translation>
    </message>
    <message>
        <source>ENVIRONMENT</source>
        <translation>UMGEBUNGSVARIABLEN</translation>
    </message>
    <message>
        <source>Folder of the window&apos;s stores.</source>
        <translation>Ordner der Datenbestände des Fensters.</translation>
    </message>
    <message>
        <source>Folder of tasks, scenes and benchmarks, if it is not next to the program.</source>
        <translation>Ordner der Aufgaben, Szenen und Richtwerte, wenn er nicht neben dem Programm ist.</translation>
    </message>
    <message>
        <source>Password of %1:</source>
        <translation>Passwort von %1:</translation>
    </message>
    <message>
        <source>Writes the certificate of a completed stage, or verifies its check code; needs --as.</source>
        <translation>Schreibt das Zertifikat einer abgeschlossenen Stufe oder prüft seinen Prüfcode; braucht --as.</translation>
    </message>
    <message>
        <source>Says whether a certificate with this code is in force.</source>
        <translation>Sagt, ob ein Zertifikat mit diesem Code gültig ist.</translation>
    </message>
    <message>
        <source>The certificate of this person.</source>
        <translation>Das Zertifikat dieser Person.</translation>
    </message>
    <message>
        <source>The completed stage, for example A.</source>
        <translation>Die abgeschlossene Stufe, zum Beispiel A.</translation>
    </message>
    <message>
        <source>The PDF to write.</source>
        <translation>Die PDF-Datei, die geschrieben wird.</translation>
    </message>
    <message>
        <source>Lets a synthetic expert perform a task (B1) and writes its report and a picture.</source>
        <translation>Lässt einen simulierten Experten eine Aufgabe durchführen (B1) und schreibt den Bericht dazu und ein Bild.</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>scope</source>
        <translation>Optik</translation>
    </message>
    <message>
        <source>    why: %1</source>
        <translation>    warum: %1</translation>
    </message>
    <message>
        <source>    what to do: %1</source>
        <translation>    was zu tun ist: %1</translation>
    </message>
    <message>
        <source>%1: median %2 us, 99.9 % %3 us, worst %4 us</source>
        <translation>%1: Median %2 us, 99.9 % %3 us, längste %4 us</translation>
    </message>
    <message>
        <source>rate: %1 readings a second of %2; %3 of %4 ticks a period late or more</source>
        <translation>Rate: %1 Messwerte je Sekunde von %2; %3 von %4 Takten um eine Periode oder mehr verspätet</translation>
    </message>
    <message>
        <source>jitter of the device&apos;s readings</source>
        <translation>Schwankung der Messwerte des Geräts</translation>
    </message>
    <message>
        <source>age of a pose when it is used</source>
        <translation>Alter einer Lage, wenn sie verwendet wird</translation>
    </message>
    <message>
        <source>force, from command to motors</source>
        <translation>Kraft, vom Befehl bis zu den Motoren</translation>
    </message>
    <message>
        <source>force: sent up to %1 N, rendered up to %2 N</source>
        <translation>Kraft: bis zu %1 N gesendet, bis zu %2 N ausgegeben</translation>
    </message>
    <message>
        <source>%1: does not answer</source>
        <translation>%1: antwortet nicht</translation>
    </message>
    <message>
        <source>%1: at (%2, %3, %4) mm, jaws %5 % open, buttons %6</source>
        <translation>%1: bei (%2, %3, %4) mm, Maul %5 % offen, Tasten %6</translation>
    </message>
    <message>
        <source>note: %1</source>
        <translation>Hinweis: %1</translation>
    </message>
    <message>
        <source>Lists the devices for the hands: what is connected, what is not, why and what to do.</source>
        <translation>Listet die Geräte für die Hände auf: was angeschlossen ist, was nicht, warum und was zu tun ist.</translation>
    </message>
    <message>
        <source>How long the test lasts: 1 to 3600.</source>
        <translation>Wie lange der Test dauert: 1 bis 3600.</translation>
    </message>
    <message>
        <source>Also send a force that rises slowly to 0.3 N along each axis in turn.</source>
        <translation>Auch eine Kraft senden, die nacheinander entlang jeder Achse langsam auf 0,3 N steigt.</translation>
    </message>
    <message>
        <source>Let a game controller rumble for half a second.</source>
        <translation>Einen Gamecontroller eine halbe Sekunde lang vibrieren lassen.</translation>
    </message>
    <message>
        <source>Writes a progress report of a person, a cohort or an attempt; needs --as, or a programme server.</source>
        <translation>Schreibt einen Bericht über den Fortschritt einer Person, einer Gruppe oder über einen Versuch; braucht --as oder einen Programmserver.</translation>
    </message>
    <message>
        <source>A report of this person.</source>
        <translation>Ein Bericht über diese Person.</translation>
    </message>
    <message>
        <source>A report of this cohort.</source>
        <translation>Ein Bericht über diese Gruppe.</translation>
    </message>
    <message>
        <source>A report of this attempt.</source>
        <translation>Ein Bericht über diesen Versuch.</translation>
    </message>
    <message>
        <source>The kind of file.</source>
        <translation>Die Art der Datei.</translation>
    </message>
    <message>
        <source>With --format xapi: the web address that the ids of your people belong to.</source>
        <translation>Mit --format xapi: die Webadresse, zu der die Kennungen Ihrer Personen gehören.</translation>
    </message>
    <message>
        <source>The file to write; with --format trace the folder.</source>
        <translation>Die Datei, die geschrieben wird; mit --format trace der Ordner.</translation>
    </message>
    <message>
        <source>Schedules a report of a cohort; needs --as, a director.</source>
        <translation>Plant einen Bericht über eine Gruppe; braucht --as, eine Programmleitung.</translation>
    </message>
    <message>
        <source>The cohort.</source>
        <translation>Die Gruppe.</translation>
    </message>
    <message>
        <source>The folder to write to, as a path from /.</source>
        <translation>Der Zielordner, als Pfad ab /.</translation>
    </message>
    <message>
        <source>How often.</source>
        <translation>Wie oft.</translation>
    </message>
    <message>
        <source>Writes the reports that are due; needs --as, a director.</source>
        <translation>Schreibt die fälligen Berichte; braucht --as, eine Programmleitung.</translation>
    </message>
    <message>
        <source>Meant for cron or a systemd timer, any number of times a day: each report is written once in its day or week (UTC), and again where its file is gone. One that fails is tried again at the next run; the exit status is 1 then, and `fulcrum schedule list` shows why. The password is read from --password-file.</source>
        <translation>Für cron oder einen systemd-Timer gedacht, beliebig oft am Tag: Jeder Bericht wird einmal in seinem Tag oder seiner Woche (UTC) geschrieben, und noch einmal, wo seine Datei fehlt. Misslingt einer, wird er beim nächsten Lauf noch einmal versucht; der Endstatus ist dann 1, und `fulcrum schedule list` zeigt den Grund. Das Passwort wird aus --password-file gelesen.</translation>
    </message>
    <message>
        <source>Lists the scheduled reports; needs --as, a director.</source>
        <translation>Listet die geplanten Berichte auf; braucht --as, eine Programmleitung.</translation>
    </message>
    <message>
        <source>Ends a schedule; needs --as, a director.</source>
        <translation>Beendet eine Planung; braucht --as, eine Programmleitung.</translation>
    </message>
    <message>
        <source>Sends statements on attempts and ratings to a learning record store.</source>
        <translation>Sendet Aussagen zu Versuchen und Beurteilungen an einen Learning Record Store.</translation>
    </message>
    <message>
        <source>The record store, such as https://lrs.example/xapi.</source>
        <translation>Der Record Store, zum Beispiel https://lrs.example/xapi.</translation>
    </message>
    <message>
        <source>A file with one line KEY:SECRET that only its owner can read (chmod 600).</source>
        <translation>Eine Datei mit einer Zeile KEY:SECRET, die nur ihr Eigentümer lesen kann (chmod 600).</translation>
    </message>
    <message>
        <source>Queue the statements of this cohort first.</source>
        <translation>Vorher die Aussagen dieser Gruppe einreihen.</translation>
    </message>
    <message>
        <source>Queue the statements of this person first.</source>
        <translation>Vorher die Aussagen dieser Person einreihen.</translation>
    </message>
    <message>
        <source>The web address that the ids of your people belong to.</source>
        <translation>Die Webadresse, zu der die Kennungen Ihrer Personen gehören.</translation>
    </message>
    <message>
        <source>Try what is quarantined once more.</source>
        <translation>Zurückgestellte Aussagen noch einmal versuchen.</translation>
    </message>
    <message>
        <source>How long an answer may take.</source>
        <translation>Wie lange eine Antwort dauern darf.</translation>
    </message>
    <message>
        <source>A director signs in with --as. Without --cohort and --person what waits is sent. Each statement has its id for good, so that it can be cut off and repeated at any time. Exit status 1 while statements wait or are quarantined.</source>
        <translation>Eine Programmleitung meldet sich mit --as an. Ohne --cohort und --person wird gesendet, was wartet. Jede Aussage behält ihre Kennung; der Befehl kann deshalb jederzeit abgebrochen und wiederholt werden. Endstatus 1, solange Aussagen warten oder zurückgestellt sind.</translation>
    </message>
    <message>
        <source>Lists how many statements wait, are done or quarantined, and why.</source>
        <translation>Listet auf, wie viele Aussagen warten, erledigt oder zurückgestellt sind, und warum.</translation>
    </message>
    <message>
        <source>south</source>
        <translation>unten</translation>
    </message>
    <message>
        <source>east</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>west</source>
        <translation>links</translation>
    </message>
    <message>
        <source>north</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>guide</source>
        <translation>Guide</translation>
    </message>
    <message>
        <source>start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>left stick</source>
        <translation>linker Stick</translation>
    </message>
    <message>
        <source>right stick</source>
        <translation>rechter Stick</translation>
    </message>
    <message>
        <source>left shoulder</source>
        <translation>linke Schultertaste</translation>
    </message>
    <message>
        <source>right shoulder</source>
        <translation>rechte Schultertaste</translation>
    </message>
    <message>
        <source>pad up</source>
        <translation>Steuerkreuz oben</translation>
    </message>
    <message>
        <source>pad down</source>
        <translation>Steuerkreuz unten</translation>
    </message>
    <message>
        <source>pad left</source>
        <translation>Steuerkreuz links</translation>
    </message>
    <message>
        <source>pad right</source>
        <translation>Steuerkreuz rechts</translation>
    </message>
    <message>
        <source>rate: %1 readings a second; longest gap %2 ms</source>
        <translation>Rate: %1 Messwerte je Sekunde; längste Lücke %2 ms</translation>
    </message>
    <message>
        <source>; never in its middle: it moves nothing</source>
        <translation>; nie in der Mitte: er bewegt nichts</translation>
    </message>
    <message>
        <source>%1: %2 to %3 % to the right, %4 to %5 % up%6; trigger up to %7 %</source>
        <translation>%1: %2 bis %3 % nach rechts, %4 bis %5 % nach oben%6; Abzug bis %7 %</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>buttons pressed: %1</source>
        <translation>gedrückte Tasten: %1</translation>
    </message>
    <message>
        <source>rumble: sent</source>
        <translation>Vibrieren: gesendet</translation>
    </message>
    <message>
        <source>rumble: refused by the controller</source>
        <translation>Vibrieren: vom Controller abgelehnt</translation>
    </message>
    <message>
        <source>ADDRESS</source>
        <translation>ADRESSE</translation>
    </message>
    <message>
        <source>ATTEMPT</source>
        <translation>VERSUCH</translation>
    </message>
    <message>
        <source>CLASS</source>
        <translation>KLASSE</translation>
    </message>
    <message>
        <source>CODE</source>
        <translation>CODE</translation>
    </message>
    <message>
        <source>COMMAND</source>
        <translation>BEFEHL</translation>
    </message>
    <message>
        <source>DEVICE</source>
        <translation>GERÄT</translation>
    </message>
    <message>
        <source>EVENTS</source>
        <translation>EREIGNISSE</translation>
    </message>
    <message>
        <source>FILE</source>
        <translation>DATEI</translation>
    </message>
    <message>
        <source>FINGERPRINT</source>
        <translation>FINGERABDRUCK</translation>
    </message>
    <message>
        <source>FOLDER</source>
        <translation>ORDNER</translation>
    </message>
    <message>
        <source>FORMAT</source>
        <translation>FORMAT</translation>
    </message>
    <message>
        <source>FROM</source>
        <translation>QUELLE</translation>
    </message>
    <message>
        <source>HEAD</source>
        <translation>KOPF</translation>
    </message>
    <message>
        <source>ID</source>
        <translation>KENNUNG</translation>
    </message>
    <message>
        <source>INTO</source>
        <translation>ZIEL</translation>
    </message>
    <message>
        <source>KIND</source>
        <translation>ART</translation>
    </message>
    <message>
        <source>LEVEL</source>
        <translation>STUFE</translation>
    </message>
    <message>
        <source>LIST</source>
        <translation>LISTE</translation>
    </message>
    <message>
        <source>LOGIN</source>
        <translation>ANMELDENAME</translation>
    </message>
    <message>
        <source>MAPPING</source>
        <translation>ZUORDNUNG</translation>
    </message>
    <message>
        <source>NEW</source>
        <translation>NEU</translation>
    </message>
    <message>
        <source>PATH</source>
        <translation>PFAD</translation>
    </message>
    <message>
        <source>PERSON</source>
        <translation>PERSON</translation>
    </message>
    <message>
        <source>RATINGS</source>
        <translation>BEURTEILUNGEN</translation>
    </message>
    <message>
        <source>ROLE</source>
        <translation>ROLLE</translation>
    </message>
    <message>
        <source>RULE</source>
        <translation>REGEL</translation>
    </message>
    <message>
        <source>SCALE</source>
        <translation>SKALA</translation>
    </message>
    <message>
        <source>SHELL</source>
        <translation>SHELL</translation>
    </message>
    <message>
        <source>TASK</source>
        <translation>AUFGABE</translation>
    </message>
    <message>
        <source>TEXT</source>
        <translation>TEXT</translation>
    </message>
    <message>
        <source>TIME</source>
        <translation>ZEIT</translation>
    </message>
    <message>
        <source>TO</source>
        <translation>ZIEL</translation>
    </message>
    <message>
        <source>TRACE</source>
        <translation>AUFZEICHNUNG</translation>
    </message>
    <message>
        <source>VALUES</source>
        <translation>WERTE</translation>
    </message>
    <message>
        <source>VERSION</source>
        <translation>VERSION</translation>
    </message>
    <message>
        <source>note: the column %1 is not known and was not read</source>
        <translation>Hinweis: Die Spalte %1 ist nicht bekannt und wurde nicht gelesen</translation>
    </message>
    <message>
        <source>note: %1 samples have a missing value and were left out</source>
        <translation>Hinweis: %1 Messwerten fehlte ein Wert; sie wurden weggelassen</translation>
    </message>
    <message>
        <source>note: %1 force samples were spikes and were replaced</source>
        <translation>Hinweis: %1 Kraftmesswerte waren Ausreißer und wurden ersetzt</translation>
    </message>
    <message>
        <source>fulcrum: sends attempt %1 at %2 as soon as a program connects; Ctrl-C ends it</source>
        <translation>fulcrum: sendet Versuch %1 an %2, sobald sich ein Programm verbindet; Strg-C beendet das</translation>
    </message>
    <message>
        <source>note: the column %1 is not mapped and was not read</source>
        <translation>Hinweis: Die Spalte %1 ist nicht zugeordnet und wurde nicht gelesen</translation>
    </message>
    <message>
        <source>note: no samples from %1 s to %2 s; nothing is measured across this gap</source>
        <translation>Hinweis: keine Messwerte von %1 s bis %2 s; über diese Lücke hinweg wird nichts gemessen</translation>
    </message>
    <message>
        <source>Also check that the newest audit row is signed by this key, or by one to which announced keys lead from it: 16 to 32 hexadecimal digits, as reports and `db audit` print them.</source>
        <translation>Auch prüfen, ob die neueste Protokollzeile mit diesem Schlüssel signiert ist oder mit einem, zu dem angekündigte Schlüssel von ihm aus führen: 16 bis 32 Hexadezimalziffern, wie Berichte und `db audit` sie nennen.</translation>
    </message>
    <message>
        <source>Erases a person of a programme without a server; needs --as, a director.</source>
        <translation>Löscht eine Person eines Programms ohne Server; braucht --as, eine Programmleitung.</translation>
    </message>
    <message>
        <source>LOGIN is a login or an id. Name, login, password, cohorts, attempts with traces and scores, comments by and about the person and what the audit log says of them are deleted; accounts that were merged into the person too. The rows of the audit log stay, and a row &quot;Erased person&quot; where others&apos; records name the person. This cannot be undone. A programme with a server erases there (`server erase`).</source>
        <translation>ANMELDENAME ist ein Anmeldename oder eine Kennung. Name, Anmeldename, Passwort, Gruppen, Versuche mit Aufzeichnungen und Bewertungen, Kommentare von der Person und über sie und was das Protokoll über sie sagt, werden gelöscht; auch Konten, die mit der Person zusammengeführt wurden. Die Zeilen des Protokolls bleiben, und eine Zeile „Erased person“, wo Einträge anderer die Person nennen. Das kann nicht rückgängig gemacht werden. Ein Programm mit Server löscht dort (`server erase`).</translation>
    </message>
    <message>
        <source>Lists the keys that signed the station&apos;s audit log, with their periods.</source>
        <translation>Listet die Schlüssel auf, mit denen das Protokoll der Station signiert wurde, mit ihren Zeiträumen.</translation>
    </message>
    <message>
        <source>Makes a new key for the station&apos;s signatures; needs --as, an administrator.</source>
        <translation>Erzeugt einen neuen Schlüssel für die Signaturen der Station; braucht --as, einen Administrator.</translation>
    </message>
    <message>
        <source>The new key signs from now on. The old one signs the row of the audit log that names the new one, then its secret half is deleted; what it signed stays valid, and nothing later is accepted from it. Rotate the key when its file may have been copied, and when somebody who could read it leaves.</source>
        <translation>Der neue Schlüssel signiert von jetzt an. Der alte signiert die Protokollzeile, die den neuen nennt, dann wird seine geheime Hälfte gelöscht; was er signiert hat, bleibt gültig, und nichts Späteres wird von ihm angenommen. Wechseln Sie den Schlüssel, wenn seine Datei kopiert worden sein kann und wenn jemand geht, der sie lesen konnte.</translation>
    </message>
    <message>
        <source>The version, such as rectal@3.</source>
        <translation>Die Version, zum Beispiel rectal@3.</translation>
    </message>
    <message>
        <source>%1.%2</source>
        <translation>%1,%2</translation>
    </message>
    <message>
        <source>PATH is a folder or ZIP archive with OneRoster CSV files (users.csv, classes.csv, enrollments.csv, roles.csv), or one CSV file with the columns login, name, role (trainee or educator) and cohort. Nobody is renamed, deactivated or removed, so an import can be repeated.</source>
        <translation>PATH ist ein Ordner oder ZIP-Archiv mit OneRoster-CSV-Dateien (users.csv, classes.csv, enrollments.csv, roles.csv) oder eine CSV-Datei mit den Spalten login, name, role (trainee oder educator) und cohort. Niemand wird umbenannt, deaktiviert oder entfernt; ein Import kann also wiederholt werden.</translation>
    </message>
    <message>
        <source>Open this device (%1) and measure rate, jitter and delays.</source>
        <translation>Dieses Gerät öffnen (%1) und Rate, Schwankung und Verzögerungen messen.</translation>
    </message>
    <message>
        <source>     Enter: done; s and Enter: leave it out</source>
        <translation>     Eingabe: fertig; s und Eingabe: weglassen</translation>
    </message>
    <message>
        <source>     Enter: done</source>
        <translation>     Eingabe: fertig</translation>
    </message>
    <message>
        <source>    movement of the instrument: %1 %</source>
        <translation>    Bewegung des Instruments: %1 %</translation>
    </message>
    <message>
        <source>mouse and keyboard</source>
        <translation>Maus und Tastatur</translation>
    </message>
    <message>
        <source>    left instrument: %1; right instrument: %2; scope: %3</source>
        <translation>    linkes Instrument: %1; rechtes Instrument: %2; Optik: %3</translation>
    </message>
    <message>
        <source>    udev rule: %1</source>
        <translation>    udev-Regel: %1</translation>
    </message>
    <message>
        <source>    calibrated: %1</source>
        <translation>    kalibriert: %1</translation>
    </message>
    <message>
        <source>%1: workspace %2 x %3 x %4 mm (across, up, deep)</source>
        <translation>%1: Arbeitsraum %2 x %3 x %4 mm (quer, hoch, tief)</translation>
    </message>
    <message>
        <source>%1: went %2 mm to the right, %3 mm to the left, %4 mm up, %5 mm down, %6 mm away from you, %7 mm towards you</source>
        <translation>%1: bewegt um %2 mm nach rechts, %3 mm nach links, %4 mm nach oben, %5 mm nach unten, %6 mm von Ihnen weg, %7 mm zu Ihnen hin</translation>
    </message>
    <message>
        <source>versions: %1</source>
        <translation>Versionen: %1</translation>
    </message>
    <message>
        <source>calibration: needed</source>
        <translation>Kalibrierung: nötig</translation>
    </message>
    <message>
        <source>calibration: valid</source>
        <translation>Kalibrierung: gültig</translation>
    </message>
    <message>
        <source>Calibrate this device step by step (%1).</source>
        <translation>Dieses Gerät Schritt für Schritt kalibrieren (%1).</translation>
    </message>
    <message>
        <source>HAND</source>
        <translation>HAND</translation>
    </message>
    <message>
        <source>Hand whose instrument is calibrated.</source>
        <translation>Hand, deren Instrument kalibriert wird.</translation>
    </message>
    <message>
        <source>Makes a token by which one station becomes one of the server&apos;s.</source>
        <translation>Erzeugt ein Token, mit dem eine Station auf dem Server aufgenommen wird.</translation>
    </message>
    <message>
        <source>How long the token is good.</source>
        <translation>Wie viele Stunden das Token gilt.</translation>
    </message>
    <message>
        <source>What you call the station.</source>
        <translation>Wie Sie die Station nennen.</translation>
    </message>
    <message>
        <source>The station gets the people of the cohorts that are named, with their attempts and reviews; without a cohort those of the whole programme. The token is shown once and works once. To change the cohorts of a station, give it another token.</source>
        <translation>Die Station bekommt die Personen der genannten Gruppen mit ihren Versuchen und Beurteilungen; ohne Gruppe die des ganzen Programms. Das Token wird einmal gezeigt und gilt einmal. Um die Gruppen einer Station zu ändern, geben Sie ihr ein weiteres Token.</translation>
    </message>
    <message>
        <source>Lists the tokens and the stations that used them.</source>
        <translation>Listet die Tokens auf und die Stationen, die sie verwendet haben.</translation>
    </message>
    <message>
        <source>Makes a token useless, or ends the access of a station (id of either).</source>
        <translation>Macht ein Token ungültig oder beendet den Zugang einer Station (Kennung des einen oder der anderen).</translation>
    </message>
    <message>
        <source>The programme server: postgresql://HOST:PORT/DATABASE; not needed once the station was enrolled.</source>
        <translation>Der Programmserver: postgresql://HOST:PORT/DATABASE; nicht nötig, wenn die Station aufgenommen ist.</translation>
    </message>
    <message>
        <source>Makes the station one of the server&apos;s first, with the token that `fulcrum server enrol` printed.</source>
        <translation>Nimmt die Station zuerst auf dem Server auf, mit dem Token, das `fulcrum server enrol` ausgegeben hat.</translation>
    </message>
    <message>
        <source>Instead: fetches the recording of an attempt of another station (--as, somebody who may see it).</source>
        <translation>Stattdessen: holt die Aufzeichnung eines Versuchs einer anderen Station (--as, jemand, der sie sehen darf).</translation>
    </message>
    <message>
        <source>COHORT</source>
        <translation>GRUPPE</translation>
    </message>
    <message>
        <source>TOKEN</source>
        <translation>TOKEN</translation>
    </message>
    <message>
        <source>Fidelities with another score than %1, measured with synthetic operators (fulcrum lab fidelity): the assessed metric that differs most, and verdicts that differ.</source>
        <translation>Genauigkeiten mit einer anderen Bewertung als %1, gemessen mit simulierten Operateuren (fulcrum lab fidelity): die bewertete Kennzahl, die am meisten abweicht, und Urteile, die abweichen.</translation>
    </message>
    <message>
        <source>%1 at %2: another verdict for %3 of %4</source>
        <translation>%1 mit %2: ein anderes Urteil bei %3 von %4</translation>
    </message>
    <message>
        <source>Every other fidelity gives the same score as the finest one.</source>
        <translation>Jede andere Genauigkeit ergibt dieselbe Bewertung wie die feinste.</translation>
    </message>
    <message>
        <source>Measured with an earlier version of the simulation or the metrics: %1.</source>
        <translation>Gemessen mit einer früheren Version der Simulation oder der Kennzahlen: %1.</translation>
    </message>
    <message>
        <source>Copies the store to a new file and checks the copy before it gets its name.</source>
        <translation>Kopiert den Datenspeicher in eine neue Datei und prüft die Kopie, bevor sie ihren Namen bekommt.</translation>
    </message>
    <message>
        <source>TO is a folder: write a file named by the time, and keep the newest N backups of this station there; older ones are removed.</source>
        <translation>TO ist ein Ordner: schreibt dort eine nach der Zeit benannte Datei und behält die neuesten N Sicherungen dieser Station; ältere werden entfernt.</translation>
    </message>
    <message>
        <source>Copy a store that does not pass the check, as it is. The name of the copy ends in -unverified.db; it replaces no backup.</source>
        <translation>Einen Datenbestand, der die Prüfung nicht besteht, so kopieren, wie er ist. Der Name der Kopie endet auf -unverified.db; sie ersetzt keine Sicherung.</translation>
    </message>
    <message>
        <source>Only what the window looks at when it starts, within a second.</source>
        <translation>Nur das, was das Fenster beim Start ansieht, innerhalb einer Sekunde.</translation>
    </message>
    <message>
        <source>Writes all that is stored about a person to a folder; needs --as, a director.</source>
        <translation>Schreibt alles, was über eine Person gespeichert ist, in einen Ordner; braucht --as, eine Programmleitung.</translation>
    </message>
    <message>
        <source>A new folder; index.html says what is in it.</source>
        <translation>Ein neuer Ordner; index.html sagt, was darin ist.</translation>
    </message>
    <message>
        <source>Only count what would be written.</source>
        <translation>Nur zählen, was geschrieben würde.</translation>
    </message>
    <message>
        <source>LOGIN is a login or an id. Attempts with scores and recordings, comments, observer forms, decisions, goals and what the audit log has of the person are written as tables (CSV) and recordings (CSV, gzip), with those of accounts that were merged into the person. The audit log says that it was done.</source>
        <translation>ANMELDENAME ist ein Anmeldename oder eine Kennung. Versuche mit Bewertungen und Aufzeichnungen, Kommentare, Beurteilungsbögen, Entscheidungen, Ziele und was das Protokoll über die Person enthält, werden als Tabellen (CSV) und Aufzeichnungen (CSV, gzip) geschrieben, auch die der Konten, die mit dem der Person zusammengeführt wurden. Das Protokoll vermerkt es.</translation>
    </message>
    <message>
        <source>Shows or sets how long data of trainees are kept, and who is due to be erased.</source>
        <translation>Zeigt oder legt fest, wie lange Daten von Lernenden aufbewahrt werden und wer zu löschen ist.</translation>
    </message>
    <message>
        <source>Keep data for so many months after the last practice or sign-in.</source>
        <translation>Daten so viele Monate nach der letzten Übung oder Anmeldung aufbewahren.</translation>
    </message>
    <message>
        <source>Set no end.</source>
        <translation>Kein Ende festlegen.</translation>
    </message>
    <message>
        <source>Erase the N people who are due; N as the list has it.</source>
        <translation>Die N Personen löschen, deren Zeit abgelaufen ist; N wie in der Liste.</translation>
    </message>
    <message>
        <source>Needs --as, a director. Trainees with no other role are due, nobody else. Nobody is erased without --erase; it does what `people erase` does. A programme with a server erases there (`server erase`).</source>
        <translation>Braucht --as, eine Programmleitung. Nur Lernende ohne andere Rolle werden aufgeführt, niemand sonst. Ohne --erase wird niemand gelöscht; es tut dasselbe wie `people erase`. Ein Programm mit einem Server löscht dort (`server erase`).</translation>
    </message>
    <message>
        <source>Simulate so many attempts again from their inputs, drawn by chance, however long it takes; 0: none. Without it: 3, in 20 seconds.</source>
        <translation>So viele zufällig gezogene Versuche aus ihren Eingaben noch einmal simulieren, wie lange es auch dauert; 0: keinen. Ohne diese Angabe: 3, in 20 Sekunden.</translation>
    </message>
    <message>
        <source>Draw the attempts that a check with this seed has drawn.</source>
        <translation>Die Versuche ziehen, die eine Prüfung mit diesem Startwert gezogen hat.</translation>
    </message>
    <message>
        <source>Of a cohort as pdf or json: the plan gives so many weeks for all tasks.</source>
        <translation>Einer Gruppe als pdf oder json: der Plan sieht so viele Wochen für alle Aufgaben vor.</translation>
    </message>
    <message>
        <source>Writes the xAPI profile of the statements: their terms and kinds, as JSON-LD.</source>
        <translation>Schreibt das xAPI-Profil der Aussagen: ihre Begriffe und Arten, als JSON-LD.</translation>
    </message>
    <message>
        <source>Write it to this file.</source>
        <translation>In diese Datei schreiben.</translation>
    </message>
    <message>
        <source>Puts curricula and benchmark sets that educators put in force at other stations into the assets folder (`fulcrum sync` and the start of the window do the same).</source>
        <translation>Legt Curricula und Richtwertsätze, die Ausbilder an anderen Stationen in Kraft gesetzt haben, in den Ordner assets (`fulcrum sync` und der Start des Fensters tun dasselbe).</translation>
    </message>
    <message>
        <source>Keep the operators&apos; attempts in this file, each as soon as it is over, and perform only those that it does not have.</source>
        <translation>Die Versuche der Operateure in dieser Datei behalten, jeden, sobald er beendet ist, und nur die ausführen, die ihr fehlen.</translation>
    </message>
    <message>
        <source>Use attempts in the file that another build of the program made; the first of each level is performed again and has to be the same.</source>
        <translation>Auch Versuche der Datei verwenden, die ein anderer Stand des Programms ausgeführt hat; der erste jeder Stufe wird noch einmal ausgeführt und muss gleich sein.</translation>
    </message>
    <message>
        <source>Gives an account another login; needs --as, an administrator.</source>
        <translation>Gibt einem Konto einen anderen Anmeldenamen; braucht --as, einen Administrator.</translation>
    </message>
    <message>
        <source>Where two stations gave the same login to two people, neither is transferred until one of them has another login: change it at the station that made the account, and sync. The password, and all that is stored of the person, stay.</source>
        <translation>Wo zwei Stationen zwei Personen denselben Anmeldenamen gegeben haben, wird keine übertragen, bis eine davon einen anderen Anmeldenamen hat: ändern Sie ihn an der Station, die das Konto angelegt hat, und synchronisieren Sie. Das Passwort und alles, was über die Person gespeichert ist, bleibt.</translation>
    </message>
    <message>
        <source>Five CSV files: attempts, metrics, people_by_task, attempts_by_task, dictionary. People and attempts have ids that are drawn again at each export, days count from a person&apos;s first attempt, values have three significant digits. Classes of devices, modes, tasks and metrics of fewer than 5 people are put together with others or left out. The two tables of counts, taken alone, give no count below 5. attempts and metrics have rows of single people, from which smaller counts follow, and somebody who knows a person&apos;s attempts well may recognise them: give these files to researchers only, and do not publish them. Give the same readers no later export without need: next to an earlier one it shows what single people did in between. A station of some cohorts of a programme exports nothing.</source>
        <translation>Fünf CSV-Dateien: attempts, metrics, people_by_task, attempts_by_task, dictionary. Personen und Versuche haben Kennungen, die bei jedem Export neu gezogen werden, Tage zählen ab dem ersten Versuch einer Person, Werte haben drei gültige Ziffern. Geräteklassen, Modi, Aufgaben und Kennzahlen von weniger als 5 Personen werden mit anderen zusammengefasst oder weggelassen. Die beiden Tabellen mit Anzahlen ergeben für sich allein keine Anzahl unter 5. attempts und metrics haben Zeilen einzelner Personen, aus denen kleinere Anzahlen folgen, und wer die Versuche einer Person gut kennt, erkennt sie vielleicht: Geben Sie diese Dateien nur an Forschende, und veröffentlichen Sie sie nicht. Geben Sie denselben Lesern nicht ohne Not einen späteren Export: Neben einem früheren zeigt er, was einzelne Personen dazwischen getan haben. Eine Station mit einem Teil der Gruppen eines Programms exportiert nichts.</translation>
    </message>
    <message>
        <source>Of the stage as completed under this version, for example rectal@1, where there are several; without it the latest.</source>
        <translation>Der Stufe, wie sie unter dieser Version abgeschlossen wurde, zum Beispiel rectal@1, wo es mehrere gibt; sonst die neueste.</translation>
    </message>
</context>
<context>
    <name>errors</name>
    <message>
        <source>a bowel of this length does not fit this cavity</source>
        <translation>ein Darm dieser Länge passt nicht in diesen Hohlraum</translation>
    </message>
    <message>
        <source>give a length nearer to 0.9 m</source>
        <translation>geben Sie eine Länge näher bei 0.9 m an</translation>
    </message>
    <message>
        <source>%1 Abandon the attempt and check the device&apos;s cable and power; the device is opened again when the next attempt begins.</source>
        <translation>%1 Brechen Sie den Versuch ab und prüfen Sie Kabel und Stromversorgung des Geräts; mit dem nächsten Versuch wird es wieder geöffnet.</translation>
    </message>
    <message>
        <source>cannot be started: %1</source>
        <translation>kann nicht gestartet werden: %1</translation>
    </message>
    <message>
        <source>install fulcrum-hapticd next to fulcrum, or name it in FULCRUM_HAPTICD</source>
        <translation>installieren Sie fulcrum-hapticd neben fulcrum, oder nennen Sie es in FULCRUM_HAPTICD</translation>
    </message>
    <message>
        <source>check that the file belongs to this version of Fulcrum</source>
        <translation>prüfen Sie, ob die Datei zu dieser Version von Fulcrum gehört</translation>
    </message>
    <message>
        <source>device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>does not open</source>
        <translation>lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>correct that and try again</source>
        <translation>beheben Sie das und versuchen Sie es noch einmal</translation>
    </message>
    <message>
        <source>did not open the device</source>
        <translation>hat das Gerät nicht geöffnet</translation>
    </message>
    <message>
        <source>check that the file belongs to this version of Fulcrum; its messages are on standard error</source>
        <translation>prüfen Sie, ob die Datei zu dieser Version von Fulcrum gehört; ihre Meldungen stehen in der Fehlerausgabe</translation>
    </message>
    <message>
        <source>ended</source>
        <translation>hat sich beendet</translation>
    </message>
    <message>
        <source>The program that drives the device %1; it is being started again.</source>
        <translation>Das Programm, das das Gerät ansteuert, %1; es wird neu gestartet.</translation>
    </message>
    <message>
        <source>The program that drives the device %1 again and again.</source>
        <translation>Das Programm, das das Gerät ansteuert, %1, und zwar immer wieder.</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>fulcrum-hapticd, which drives the device, ended.</source>
        <translation>fulcrum-hapticd, das das Gerät ansteuert, hat sich beendet.</translation>
    </message>
    <message>
        <source>fulcrum-hapticd, which drives the device, does not answer.</source>
        <translation>fulcrum-hapticd, das das Gerät ansteuert, antwortet nicht.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not known</source>
        <translation>„%1“ ist nicht bekannt</translation>
    </message>
    <message>
        <source>check the file</source>
        <translation>prüfen Sie die Datei</translation>
    </message>
    <message>
        <source>is larger than 256 MiB</source>
        <translation>ist größer als 256 MiB</translation>
    </message>
    <message>
        <source>use a shorter recording</source>
        <translation>verwenden Sie eine kürzere Aufzeichnung</translation>
    </message>
    <message>
        <source>is not JSON: %1</source>
        <translation>ist kein JSON: %1</translation>
    </message>
    <message>
        <source>correct the document</source>
        <translation>berichtigen Sie das Dokument</translation>
    </message>
    <message>
        <source>must be &quot;fulcrum-device-script&quot;</source>
        <translation>muss &quot;fulcrum-device-script&quot; sein</translation>
    </message>
    <message>
        <source>add it, or name another file</source>
        <translation>fügen Sie es hinzu, oder nennen Sie eine andere Datei</translation>
    </message>
    <message>
        <source>must be a short text</source>
        <translation>muss ein kurzer Text sein</translation>
    </message>
    <message>
        <source>give a text of at most 200 bytes</source>
        <translation>geben Sie einen Text von höchstens 200 Bytes an</translation>
    </message>
    <message>
        <source>must be true or false</source>
        <translation>muss true oder false sein</translation>
    </message>
    <message>
        <source>correct it</source>
        <translation>berichtigen Sie es</translation>
    </message>
    <message>
        <source>has none of left, right, scope and recording</source>
        <translation>hat keines von left, right, scope und recording</translation>
    </message>
    <message>
        <source>give at least one</source>
        <translation>geben Sie mindestens eines an</translation>
    </message>
    <message>
        <source>must be an object</source>
        <translation>muss ein Objekt sein</translation>
    </message>
    <message>
        <source>write { … }</source>
        <translation>schreiben Sie { … }</translation>
    </message>
    <message>
        <source>is not a key of a device script</source>
        <translation>ist kein Schlüssel eines Geräteskripts</translation>
    </message>
    <message>
        <source>remove it or correct its name</source>
        <translation>entfernen Sie ihn, oder berichtigen Sie seinen Namen</translation>
    </message>
    <message>
        <source>must be a number from %1 to %2</source>
        <translation>muss eine Zahl von %1 bis %2 sein</translation>
    </message>
    <message>
        <source>correct the value</source>
        <translation>berichtigen Sie den Wert</translation>
    </message>
    <message>
        <source>must be the name of a file</source>
        <translation>muss der Name einer Datei sein</translation>
    </message>
    <message>
        <source>write the name as a text</source>
        <translation>schreiben Sie den Namen als Text</translation>
    </message>
    <message>
        <source>must be a list with at least one point</source>
        <translation>muss eine Liste mit mindestens einem Punkt sein</translation>
    </message>
    <message>
        <source>write [{&quot;t&quot;: 0, &quot;position&quot;: [0, 0, 0]}]</source>
        <translation>schreiben Sie [{&quot;t&quot;: 0, &quot;position&quot;: [0, 0, 0]}]</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>give the points of the path</source>
        <translation>geben Sie die Punkte des Weges an</translation>
    </message>
    <message>
        <source>is not for the scope</source>
        <translation>gilt nicht für die Optik</translation>
    </message>
    <message>
        <source>remove it</source>
        <translation>entfernen Sie es</translation>
    </message>
    <message>
        <source>give the time in seconds</source>
        <translation>geben Sie die Zeit in Sekunden an</translation>
    </message>
    <message>
        <source>must be later than the point before</source>
        <translation>muss später sein als der Punkt davor</translation>
    </message>
    <message>
        <source>sort the points by time</source>
        <translation>ordnen Sie die Punkte nach der Zeit</translation>
    </message>
    <message>
        <source>must be three numbers in metres</source>
        <translation>müssen drei Zahlen in Metern sein</translation>
    </message>
    <message>
        <source>write [x, y, z]</source>
        <translation>schreiben Sie [x, y, z]</translation>
    </message>
    <message>
        <source>must be within 1 m of the origin</source>
        <translation>muss innerhalb von 1 m um den Ursprung liegen</translation>
    </message>
    <message>
        <source>give metres</source>
        <translation>geben Sie Meter an</translation>
    </message>
    <message>
        <source>must be a list</source>
        <translation>muss eine Liste sein</translation>
    </message>
    <message>
        <source>write [ … ]</source>
        <translation>schreiben Sie [ … ]</translation>
    </message>
    <message>
        <source>is not a fault</source>
        <translation>ist keine Störung</translation>
    </message>
    <message>
        <source>use silence, not_a_number or jump</source>
        <translation>verwenden Sie silence, not_a_number oder jump</translation>
    </message>
    <message>
        <source>the first line must be %1</source>
        <translation>die erste Zeile muss %1 sein</translation>
    </message>
    <message>
        <source>write this line first, as docs/DEVICES.md describes</source>
        <translation>schreiben Sie diese Zeile an den Anfang, wie in docs/DEVICES.md beschrieben</translation>
    </message>
    <message>
        <source>must have 8 columns</source>
        <translation>muss 8 Spalten haben</translation>
    </message>
    <message>
        <source>correct the row</source>
        <translation>berichtigen Sie die Zeile</translation>
    </message>
    <message>
        <source>slot &apos;%1&apos; is not known</source>
        <translation>„%1“ ist nicht bekannt</translation>
    </message>
    <message>
        <source>use left, right or scope</source>
        <translation>verwenden Sie left, right oder scope</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a usable number</source>
        <translation>„%1“ ist keine brauchbare Zahl</translation>
    </message>
    <message>
        <source>correct column %1</source>
        <translation>berichtigen Sie die Spalte %1</translation>
    </message>
    <message>
        <source>sort the rows of each slot by time</source>
        <translation>ordnen Sie die Zeilen jeder Hand nach der Zeit</translation>
    </message>
    <message>
        <source>too many rows</source>
        <translation>zu viele Zeilen</translation>
    </message>
    <message>
        <source>has no readings</source>
        <translation>enthält keine Messwerte</translation>
    </message>
    <message>
        <source>record again</source>
        <translation>nehmen Sie noch einmal auf</translation>
    </message>
    <message>
        <source>was stopped</source>
        <translation>wurde angehalten</translation>
    </message>
    <message>
        <source>was ended by signal %1</source>
        <translation>wurde durch Signal %1 beendet</translation>
    </message>
    <message>
        <source>ended with status %1</source>
        <translation>hat sich mit Status %1 beendet</translation>
    </message>
    <message>
        <source>cannot be written (%1)</source>
        <translation>kann nicht geschrieben werden (%1)</translation>
    </message>
    <message>
        <source>name a regular file in a folder that can be written and has space</source>
        <translation>nennen Sie eine gewöhnliche Datei in einem Ordner, der beschreibbar ist und Platz hat</translation>
    </message>
    <message>
        <source>cannot be read (%1)</source>
        <translation>kann nicht gelesen werden (%1)</translation>
    </message>
    <message>
        <source>check the path and the permission to read it</source>
        <translation>prüfen Sie den Pfad und die Leseberechtigung</translation>
    </message>
    <message>
        <source>is %1, not a regular file</source>
        <translation>ist %1, keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>name a regular file</source>
        <translation>nennen Sie eine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>there are more vessels than bands</source>
        <translation>es gibt mehr Gefäße als Stränge</translation>
    </message>
    <message>
        <source>give at most &quot;count&quot;</source>
        <translation>geben Sie höchstens &quot;count&quot; an</translation>
    </message>
    <message>
        <source>the bed is too small for two columns of such bands</source>
        <translation>das Bett ist zu klein für zwei Reihen solcher Stränge</translation>
    </message>
    <message>
        <source>give a wider bed, fewer bands or shorter ones</source>
        <translation>geben Sie ein breiteres Bett, weniger oder kürzere Stränge an</translation>
    </message>
    <message>
        <source>the bed is larger than 0.6 m or its rim is below its middle</source>
        <translation>das Bett ist größer als 0.6 m, oder sein Rand liegt tiefer als seine Mitte</translation>
    </message>
    <message>
        <source>give half edges in metres</source>
        <translation>geben Sie halbe Kantenlängen in Metern an</translation>
    </message>
    <message>
        <source>the nerve is below the bed</source>
        <translation>der Nerv liegt unter dem Bett</translation>
    </message>
    <message>
        <source>give a gap below &quot;height&quot;</source>
        <translation>geben Sie einen Abstand unter &quot;height&quot; an</translation>
    </message>
    <message>
        <source>the layers together are thicker than the bowel&apos;s radius</source>
        <translation>die Schichten sind zusammen dicker als der Radius des Darms</translation>
    </message>
    <message>
        <source>give layers whose thicknesses add up to less than outer_radius</source>
        <translation>geben Sie Schichten an, deren Dicken zusammen kleiner sind als outer_radius</translation>
    </message>
    <message>
        <source>a nodule needs a wall with layers</source>
        <translation>ein Knoten braucht eine Wand mit Schichten</translation>
    </message>
    <message>
        <source>give the bowel &quot;layers&quot;</source>
        <translation>geben Sie dem Darm &quot;layers&quot;</translation>
    </message>
    <message>
        <source>the nodule is thicker than the layer that it replaces</source>
        <translation>der Knoten ist dicker als die Schicht, die er ersetzt</translation>
    </message>
    <message>
        <source>give a height of at most the first layer&apos;s thickness</source>
        <translation>geben Sie höchstens die Dicke der ersten Schicht an</translation>
    </message>
    <message>
        <source>the wall is thicker than the bowel&apos;s radius</source>
        <translation>die Wand ist dicker als der Radius des Darms</translation>
    </message>
    <message>
        <source>give a wall thinner than outer_radius</source>
        <translation>geben Sie eine Wand an, die dünner ist als outer_radius</translation>
    </message>
    <message>
        <source>the spheres would leave gaps, or there would be more than 1000</source>
        <translation>zwischen den Kugeln blieben Lücken, oder es wären mehr als 1000</translation>
    </message>
    <message>
        <source>give a spacing near outer_radius, below four times it</source>
        <translation>geben Sie einen Abstand nahe outer_radius an, unter dem Vierfachen davon</translation>
    </message>
    <message>
        <source>the balls do not fit into the cups</source>
        <translation>die Kugeln passen nicht in die Becher</translation>
    </message>
    <message>
        <source>give smaller balls or wider cups</source>
        <translation>geben Sie kleinere Kugeln oder weitere Becher an</translation>
    </message>
    <message>
        <source>the lens would be in the cup</source>
        <translation>die Linse läge im Becher</translation>
    </message>
    <message>
        <source>give a larger distance, a shallower cup or a thinner scope</source>
        <translation>geben Sie einen größeren Abstand, einen flacheren Becher oder eine dünnere Optik an</translation>
    </message>
    <message>
        <source>least_insertion is above most_insertion</source>
        <translation>least_insertion liegt über most_insertion</translation>
    </message>
    <message>
        <source>give at most the value of most_insertion</source>
        <translation>geben Sie höchstens den Wert von most_insertion an</translation>
    </message>
    <message>
        <source>give three values from 0 on</source>
        <translation>geben Sie drei Werte ab 0 an</translation>
    </message>
    <message>
        <source>give at least one instrument, or &quot;camera_targets&quot;</source>
        <translation>geben Sie mindestens ein Instrument oder &quot;camera_targets&quot; an</translation>
    </message>
    <message>
        <source>the tissue &quot;%1&quot; is not listed</source>
        <translation>das Gewebe „%1“ ist nicht aufgeführt</translation>
    </message>
    <message>
        <source>add it to &quot;tissues&quot; or name another</source>
        <translation>fügen Sie es zu &quot;tissues&quot; hinzu, oder nennen Sie ein anderes</translation>
    </message>
    <message>
        <source>targets to look at need a scope</source>
        <translation>Ziele zum Ansehen brauchen eine Optik</translation>
    </message>
    <message>
        <source>add &quot;camera&quot;</source>
        <translation>fügen Sie &quot;camera&quot; hinzu</translation>
    </message>
    <message>
        <source>a scene for the scope alone has no instruments and no targets to touch</source>
        <translation>eine Szene nur für die Optik hat keine Instrumente und keine Ziele zum Berühren</translation>
    </message>
    <message>
        <source>remove &quot;instruments&quot; and &quot;targets&quot;, or &quot;camera_targets&quot;</source>
        <translation>entfernen Sie &quot;instruments&quot; und &quot;targets&quot;, oder &quot;camera_targets&quot;</translation>
    </message>
    <message>
        <source>cups for the camera would lie in the tissue</source>
        <translation>Becher für die Kamera lägen im Gewebe</translation>
    </message>
    <message>
        <source>remove &quot;%1&quot; or &quot;camera_targets&quot;</source>
        <translation>entfernen Sie &quot;%1&quot; oder &quot;camera_targets&quot;</translation>
    </message>
    <message>
        <source>this is not a cutting value</source>
        <translation>das ist kein Schneidewert</translation>
    </message>
    <message>
        <source>use one of %1</source>
        <translation>verwenden Sie einen der folgenden: %1</translation>
    </message>
    <message>
        <source>%1 is out of range</source>
        <translation>%1 liegt außerhalb des erlaubten Bereichs</translation>
    </message>
    <message>
        <source>the scene has no tissue of this name with cutting values</source>
        <translation>die Szene hat kein Gewebe dieses Namens mit Schneidewerten</translation>
    </message>
    <message>
        <source>choose a task in which tissue is cut</source>
        <translation>wählen Sie eine Aufgabe, in der Gewebe geschnitten wird</translation>
    </message>
    <message>
        <source>command line</source>
        <translation>Befehlszeile</translation>
    </message>
    <message>
        <source>unknown fidelity &quot;%1&quot;</source>
        <translation>unbekannte Genauigkeit „%1“</translation>
    </message>
    <message>
        <source>give one of: %1</source>
        <translation>geben Sie eines an von: %1</translation>
    </message>
    <message>
        <source>the file cannot be opened</source>
        <translation>die Datei kann nicht geöffnet werden</translation>
    </message>
    <message>
        <source>the file cannot be read</source>
        <translation>die Datei kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>give a regular file, not a folder</source>
        <translation>geben Sie eine gewöhnliche Datei an, keinen Ordner</translation>
    </message>
    <message>
        <source>the file is larger than %1 bytes</source>
        <translation>die Datei ist größer als %1 Bytes</translation>
    </message>
    <message>
        <source>split it or remove what it does not need</source>
        <translation>teilen Sie sie auf, oder entfernen Sie, was sie nicht braucht</translation>
    </message>
    <message>
        <source>the text is larger than %1 bytes</source>
        <translation>der Text ist größer als %1 Bytes</translation>
    </message>
    <message>
        <source>remove what it does not need</source>
        <translation>entfernen Sie, was er nicht braucht</translation>
    </message>
    <message>
        <source>the text is nested deeper than %1 levels</source>
        <translation>der Text ist tiefer als %1 Ebenen verschachtelt</translation>
    </message>
    <message>
        <source>check for a bracket that is never closed</source>
        <translation>suchen Sie eine Klammer, die nicht geschlossen wird</translation>
    </message>
    <message>
        <source>the text is not valid JSON: %1</source>
        <translation>der Text ist kein gültiges JSON: %1</translation>
    </message>
    <message>
        <source>correct the text at this line or just before it</source>
        <translation>berichtigen Sie den Text in dieser Zeile oder unmittelbar davor</translation>
    </message>
    <message>
        <source>the key is given twice</source>
        <translation>der Schlüssel ist doppelt angegeben</translation>
    </message>
    <message>
        <source>remove one of the two</source>
        <translation>entfernen Sie einen von beiden</translation>
    </message>
    <message>
        <source>unknown name %1</source>
        <translation>unbekannter Name %1</translation>
    </message>
    <message>
        <source>the rings do not fit around the pegs</source>
        <translation>die Ringe passen nicht um die Stifte</translation>
    </message>
    <message>
        <source>give larger rings, thinner tubes or thinner pegs</source>
        <translation>geben Sie größere Ringe, dünnere Rohre oder dünnere Stifte an</translation>
    </message>
    <message>
        <source>rings around neighbouring pegs would overlap</source>
        <translation>Ringe um benachbarte Stifte würden sich überlappen</translation>
    </message>
    <message>
        <source>give pegs that are further apart, smaller rings or less jitter</source>
        <translation>geben Sie weiter entfernte Stifte, kleinere Ringe oder weniger Streuung an</translation>
    </message>
    <message>
        <source>the pegs do not fit on the tray side by side</source>
        <translation>die Stifte passen nicht nebeneinander auf das Tablett</translation>
    </message>
    <message>
        <source>give a larger tray, a gap of at least twice the spacing, or fewer rings</source>
        <translation>geben Sie ein größeres Tablett, eine Lücke vom mindestens doppelten Abstand oder weniger Ringe an</translation>
    </message>
    <message>
        <source>the tissue &quot;%1&quot; is given twice</source>
        <translation>das Gewebe „%1“ ist doppelt angegeben</translation>
    </message>
    <message>
        <source>give every tissue its own label</source>
        <translation>geben Sie jedem Gewebe einen eigenen Namen</translation>
    </message>
    <message>
        <source>the spread is above 0.4 of perforation_force</source>
        <translation>die Streuung ist größer als 0.4 von perforation_force</translation>
    </message>
    <message>
        <source>give a smaller spread or a larger perforation_force</source>
        <translation>geben Sie eine kleinere Streuung oder eine größere perforation_force an</translation>
    </message>
    <message>
        <source>dynamic_friction_n is above static_friction_n</source>
        <translation>dynamic_friction_n liegt über static_friction_n</translation>
    </message>
    <message>
        <source>give at most the value of static_friction_n</source>
        <translation>geben Sie höchstens den Wert von static_friction_n an</translation>
    </message>
    <message>
        <source>a tissue without friction carries no force along it, so no blade can break through</source>
        <translation>ein Gewebe ohne Reibung trägt in Längsrichtung keine Kraft, also kann keine Klinge durchbrechen</translation>
    </message>
    <message>
        <source>give the tissue a friction above 0</source>
        <translation>geben Sie dem Gewebe eine Reibung über 0</translation>
    </message>
    <message>
        <source>the trocar is more than 1 m from the pelvis</source>
        <translation>der Trokar ist mehr als 1 m vom Becken entfernt</translation>
    </message>
    <message>
        <source>give metres, not millimetres</source>
        <translation>geben Sie Meter an, nicht Millimeter</translation>
    </message>
    <message>
        <source>the direction has no length</source>
        <translation>die Richtung hat keine Länge</translation>
    </message>
    <message>
        <source>give a vector from the trocar into the body</source>
        <translation>geben Sie einen Vektor vom Trokar in den Körper an</translation>
    </message>
    <message>
        <source>up is parallel to the direction</source>
        <translation>up ist parallel zur Richtung</translation>
    </message>
    <message>
        <source>give an up vector at least 3 degrees away from the shaft</source>
        <translation>geben Sie einen Vektor an, der mindestens 3 Grad vom Schaft abweicht</translation>
    </message>
    <message>
        <source>the start insertion exceeds 0.9 of the shaft&apos;s length</source>
        <translation>die Einführtiefe am Anfang überschreitet 0.9 der Schaftlänge</translation>
    </message>
    <message>
        <source>give a smaller start_insertion or a longer shaft_length</source>
        <translation>geben Sie eine kleinere start_insertion oder eine größere shaft_length an</translation>
    </message>
    <message>
        <source>the %1 hand holds two instruments</source>
        <translation>die %1 Hand hält zwei Instrumente</translation>
    </message>
    <message>
        <source>instruments are exchanged where nothing needs another</source>
        <translation>Instrumente werden gewechselt, wo nichts ein anderes braucht</translation>
    </message>
    <message>
        <source>add &quot;bands&quot; or &quot;structures&quot; to the scene or remove &quot;exchange&quot;</source>
        <translation>fügen Sie der Szene &quot;bands&quot; oder &quot;structures&quot; hinzu, oder entfernen Sie &quot;exchange&quot;</translation>
    </message>
    <message>
        <source>the first of &quot;exchange&quot; is not &quot;kind&quot;</source>
        <translation>das erste von &quot;exchange&quot; ist nicht &quot;kind&quot;</translation>
    </message>
    <message>
        <source>start the list with what the hand holds at the start</source>
        <translation>beginnen Sie die Liste mit dem, was die Hand am Anfang hält</translation>
    </message>
    <message>
        <source>the box has an edge of 0 or above 0.6 m</source>
        <translation>der Kasten hat eine Kante von 0 oder über 0.6 m</translation>
    </message>
    <message>
        <source>give three half edges in metres, each above 0</source>
        <translation>geben Sie drei halbe Kantenlängen in Metern an, jede über 0</translation>
    </message>
    <message>
        <source>the box has no room for this many targets at this distance</source>
        <translation>im Kasten ist bei diesem Abstand kein Platz für so viele Ziele</translation>
    </message>
    <message>
        <source>give fewer targets, a smaller minimum_distance or a larger half_extent</source>
        <translation>geben Sie weniger Ziele, eine kleinere minimum_distance oder eine größere half_extent an</translation>
    </message>
    <message>
        <source>tethers need a bowel</source>
        <translation>Haltebänder brauchen einen Darm</translation>
    </message>
    <message>
        <source>add a &quot;bowel&quot; or remove &quot;tethers&quot;</source>
        <translation>fügen Sie &quot;bowel&quot; hinzu, oder entfernen Sie &quot;tethers&quot;</translation>
    </message>
    <message>
        <source>first must be below last</source>
        <translation>first muss kleiner sein als last</translation>
    </message>
    <message>
        <source>give first &lt; last, fractions of the bowel&apos;s length</source>
        <translation>geben Sie first &lt; last an, als Anteile der Darmlänge</translation>
    </message>
    <message>
        <source>a membrane needs a bowel and a cavity to attach to</source>
        <translation>eine Membran braucht einen Darm und einen Hohlraum, an denen sie ansetzt</translation>
    </message>
    <message>
        <source>add &quot;bowel&quot; and &quot;cavity&quot; or remove &quot;membranes&quot;</source>
        <translation>fügen Sie &quot;bowel&quot; und &quot;cavity&quot; hinzu, oder entfernen Sie &quot;membranes&quot;</translation>
    </message>
    <message>
        <source>give a vector in the sheet&apos;s plane</source>
        <translation>geben Sie einen Vektor in der Ebene der Gewebeplatte an</translation>
    </message>
    <message>
        <source>across is parallel to the marked line</source>
        <translation>across ist parallel zur markierten Linie</translation>
    </message>
    <message>
        <source>give a direction at right angles to &quot;along&quot;</source>
        <translation>geben Sie eine Richtung im rechten Winkel zu &quot;along&quot; an</translation>
    </message>
    <message>
        <source>the marked line is longer than the sheet</source>
        <translation>die markierte Linie ist länger als die Gewebeplatte</translation>
    </message>
    <message>
        <source>give at most length</source>
        <translation>geben Sie höchstens length an</translation>
    </message>
    <message>
        <source>the sheet would have fewer than five vertices along an edge, or more than 20000 in total</source>
        <translation>die Gewebeplatte hätte weniger als fünf Punkte je Kante oder mehr als 20000 insgesamt</translation>
    </message>
    <message>
        <source>give a spacing that suits length and width</source>
        <translation>geben Sie einen Abstand an, der zu Länge und Breite passt</translation>
    </message>
    <message>
        <source>a presacral wall needs a rectum</source>
        <translation>eine präsakrale Wand braucht ein Rektum</translation>
    </message>
    <message>
        <source>add a bowel of layout &quot;rectum&quot;</source>
        <translation>fügen Sie einen Darm mit dem Verlauf &quot;rectum&quot; hinzu</translation>
    </message>
    <message>
        <source>a rectum and a presacral wall need each other</source>
        <translation>Rektum und präsakrale Wand gehören zusammen</translation>
    </message>
    <message>
        <source>give the bowel the layout &quot;rectum&quot; and the scene &quot;presacral&quot;, or neither</source>
        <translation>geben Sie dem Darm den Verlauf &quot;rectum&quot; und der Szene &quot;presacral&quot;, oder keines von beiden</translation>
    </message>
    <message>
        <source>a scene with a presacral wall cannot have a cavity, tethers, membranes or targets</source>
        <translation>eine Szene mit präsakraler Wand kann weder Hohlraum noch Haltebänder, Membranen oder Ziele haben</translation>
    </message>
    <message>
        <source>remove cavity, tethers, membranes and targets</source>
        <translation>entfernen Sie cavity, tethers, membranes und targets</translation>
    </message>
    <message>
        <source>septa need a rectum and a presacral wall, and exclude a sheet</source>
        <translation>Septen brauchen ein Rektum und eine präsakrale Wand und schließen eine Gewebeplatte aus</translation>
    </message>
    <message>
        <source>add &quot;presacral&quot; and a bowel of layout &quot;rectum&quot;, and remove &quot;sheet&quot;</source>
        <translation>fügen Sie &quot;presacral&quot; und einen Darm mit dem Verlauf &quot;rectum&quot; hinzu, und entfernen Sie &quot;sheet&quot;</translation>
    </message>
    <message>
        <source>bands cannot be combined with a bowel, cavity, sheet or targets</source>
        <translation>Stränge lassen sich nicht mit Darm, Hohlraum, Gewebeplatte oder Zielen verbinden</translation>
    </message>
    <message>
        <source>remove those parts or &quot;bands&quot;</source>
        <translation>entfernen Sie diese Teile oder &quot;bands&quot;</translation>
    </message>
    <message>
        <source>structures need a presacral wall</source>
        <translation>Strukturen brauchen eine präsakrale Wand</translation>
    </message>
    <message>
        <source>add &quot;presacral&quot; or remove &quot;structures&quot;</source>
        <translation>fügen Sie &quot;presacral&quot; hinzu, oder entfernen Sie &quot;structures&quot;</translation>
    </message>
    <message>
        <source>bands and structures cannot be combined</source>
        <translation>Stränge und Strukturen lassen sich nicht verbinden</translation>
    </message>
    <message>
        <source>remove &quot;bands&quot; or &quot;structures&quot;</source>
        <translation>entfernen Sie &quot;bands&quot; oder &quot;structures&quot;</translation>
    </message>
    <message>
        <source>objects on a tray cannot be combined with tissue, cavity or targets</source>
        <translation>Objekte auf einem Tablett lassen sich nicht mit Gewebe, Hohlraum oder Zielen verbinden</translation>
    </message>
    <message>
        <source>remove those parts or &quot;objects&quot;</source>
        <translation>entfernen Sie diese Teile oder &quot;objects&quot;</translation>
    </message>
    <message>
        <source>the tissue &quot;%1&quot; is not in the list of tissues</source>
        <translation>das Gewebe „%1“ steht nicht in der Liste der Gewebe</translation>
    </message>
    <message>
        <source>use one of: %1, or add it to &quot;tissues&quot;</source>
        <translation>verwenden Sie eines von: %1, oder fügen Sie es zu &quot;tissues&quot; hinzu</translation>
    </message>
    <message>
        <source>the promontory is beyond an end of the rectum</source>
        <translation>das Promontorium liegt jenseits eines Endes des Rektums</translation>
    </message>
    <message>
        <source>give an angle between the rectum&apos;s ends</source>
        <translation>geben Sie einen Winkel zwischen den Enden des Rektums an</translation>
    </message>
    <message>
        <source>the intended plane is outside the areolar zone</source>
        <translation>die vorgesehene Schicht liegt außerhalb der areolären Zone</translation>
    </message>
    <message>
        <source>give less than areolar_height</source>
        <translation>geben Sie weniger als areolar_height an</translation>
    </message>
    <message>
        <source>the areolar zone leaves no room for the mesorectal fat</source>
        <translation>die areoläre Zone lässt keinen Platz für das mesorektale Fett</translation>
    </message>
    <message>
        <source>give less than 0.8 of presacral.gap</source>
        <translation>geben Sie weniger als 0.8 von presacral.gap an</translation>
    </message>
    <message>
        <source>the septa would extend around the rectum</source>
        <translation>die Septen würden um das Rektum herumreichen</translation>
    </message>
    <message>
        <source>give less, or a wider presacral.gap or rectum</source>
        <translation>geben Sie weniger an, oder ein größeres presacral.gap oder Rektum</translation>
    </message>
    <message>
        <source>a septum would have fewer than five vertices along it, or more than 200</source>
        <translation>ein Septum hätte der Länge nach weniger als fünf oder mehr als 200 Punkte</translation>
    </message>
    <message>
        <source>give a spacing that suits the width</source>
        <translation>geben Sie einen Abstand an, der zur Breite passt</translation>
    </message>
    <message>
        <source>a septum is above the promontory or below the rectum</source>
        <translation>ein Septum liegt oberhalb des Promontoriums oder unterhalb des Rektums</translation>
    </message>
    <message>
        <source>give fewer or closer septa, another first angle or a longer rectum</source>
        <translation>geben Sie weniger oder engere Septen, einen anderen ersten Winkel oder ein längeres Rektum an</translation>
    </message>
    <message>
        <source>a rung is wider than the veins it joins</source>
        <translation>eine Quervene ist weiter als die Venen, die sie verbindet</translation>
    </message>
    <message>
        <source>give at most &quot;vessel_radius&quot;</source>
        <translation>geben Sie höchstens &quot;vessel_radius&quot; an</translation>
    </message>
    <message>
        <source>the nerves would be inside the fascia</source>
        <translation>die Nerven lägen in der Faszie</translation>
    </message>
    <message>
        <source>give at least &quot;nerve_radius&quot;</source>
        <translation>geben Sie mindestens &quot;nerve_radius&quot; an</translation>
    </message>
    <message>
        <source>veins that wander this far would intersect</source>
        <translation>Venen, die so weit abweichen, würden sich schneiden</translation>
    </message>
    <message>
        <source>give at most half of &quot;vein_lateral&quot;</source>
        <translation>geben Sie höchstens die Hälfte von &quot;vein_lateral&quot; an</translation>
    </message>
    <message>
        <source>the membrane is too stiff or heavy for the bowel&apos;s mass at this step</source>
        <translation>die Membran ist bei dieser Schrittweite zu steif oder zu schwer für die Masse des Darms</translation>
    </message>
    <message>
        <source>lower its stiffness, stiffness_damping or surface_density, or take fewer ticks_per_step</source>
        <translation>senken Sie ihre stiffness, stiffness_damping oder surface_density, oder nehmen Sie weniger ticks_per_step</translation>
    </message>
    <message>
        <source>the septa are too stiff or heavy for the bowel&apos;s mass at this step</source>
        <translation>die Septen sind bei dieser Schrittweite zu steif oder zu schwer für die Masse des Darms</translation>
    </message>
    <message>
        <source>lower their stiffness, stiffness_damping or surface_density, or take fewer ticks_per_step</source>
        <translation>senken Sie ihre stiffness, stiffness_damping oder surface_density, oder nehmen Sie weniger ticks_per_step</translation>
    </message>
    <message>
        <source>needs a cavity to lie in</source>
        <translation>braucht einen Hohlraum, in dem er liegt</translation>
    </message>
    <message>
        <source>add a cavity to the scene</source>
        <translation>fügen Sie der Szene einen Hohlraum hinzu</translation>
    </message>
    <message>
        <source>only %1 cups have room where the scope can see them</source>
        <translation>nur %1 Becher haben dort Platz, wo die Optik sie sehen kann</translation>
    </message>
    <message>
        <source>ask for fewer cups, less spacing or more swing of the scope</source>
        <translation>verlangen Sie weniger Becher, kleinere Abstände oder mehr Schwenk der Optik</translation>
    </message>
    <message>
        <source>the sheet is too stiff for its mass at this step</source>
        <translation>die Gewebeplatte ist bei dieser Schrittweite zu steif für ihre Masse</translation>
    </message>
    <message>
        <source>lower its stiffness, raise surface_density or take fewer ticks_per_step</source>
        <translation>senken Sie ihre stiffness, erhöhen Sie surface_density, oder nehmen Sie weniger ticks_per_step</translation>
    </message>
    <message>
        <source>more targets than the local model holds</source>
        <translation>mehr Ziele, als das lokale Modell fasst</translation>
    </message>
    <message>
        <source>use at most %1</source>
        <translation>verwenden Sie höchstens %1</translation>
    </message>
    <message>
        <source>set FULCRUM_ASSETS to the assets folder</source>
        <translation>setzen Sie FULCRUM_ASSETS auf den Ordner assets</translation>
    </message>
    <message>
        <source>assets</source>
        <translation>Mitgeliefertes</translation>
    </message>
    <message>
        <source>no task &apos;%1&apos;</source>
        <translation>es gibt keine Aufgabe „%1“</translation>
    </message>
    <message>
        <source>name one of %1</source>
        <translation>nennen Sie eine von %1</translation>
    </message>
    <message>
        <source>begin at an earlier goal</source>
        <translation>beginnen Sie bei einem früheren Schritt</translation>
    </message>
    <message>
        <source>stage %1 is listed twice</source>
        <translation>die Stufe %1 ist doppelt aufgeführt</translation>
    </message>
    <message>
        <source>give every stage its own id</source>
        <translation>geben Sie jeder Stufe eine eigene Kennung</translation>
    </message>
    <message>
        <source>%1 is not a task of this curriculum</source>
        <translation>%1 ist keine Aufgabe dieses Curriculums</translation>
    </message>
    <message>
        <source>add it to /tasks, or remove it here</source>
        <translation>fügen Sie sie zu /tasks hinzu, oder entfernen Sie sie hier</translation>
    </message>
    <message>
        <source>%1 belongs to a later stage than %2</source>
        <translation>%1 gehört zu einer späteren Stufe als %2</translation>
    </message>
    <message>
        <source>name tasks of the same or an earlier stage</source>
        <translation>nennen Sie Aufgaben derselben oder einer früheren Stufe</translation>
    </message>
    <message>
        <source>%1 would unlock only after itself</source>
        <translation>%1 würde erst nach sich selbst frei</translation>
    </message>
    <message>
        <source>remove one of the prerequisites on the way back to %1</source>
        <translation>entfernen Sie eine der Voraussetzungen auf dem Weg zurück zu %1</translation>
    </message>
    <message>
        <source>no task %1 is installed</source>
        <translation>die Aufgabe %1 ist nicht installiert</translation>
    </message>
    <message>
        <source>name a file of assets/tasks</source>
        <translation>nennen Sie eine Datei aus assets/tasks</translation>
    </message>
    <message>
        <source>%1 is listed twice</source>
        <translation>%1 ist doppelt aufgeführt</translation>
    </message>
    <message>
        <source>list every task once</source>
        <translation>führen Sie jede Aufgabe einmal auf</translation>
    </message>
    <message>
        <source>there is no stage %1</source>
        <translation>es gibt keine Stufe %1</translation>
    </message>
    <message>
        <source>name one of /stages, or add it there</source>
        <translation>nennen Sie eine aus /stages, oder fügen Sie sie dort hinzu</translation>
    </message>
    <message>
        <source>install the program&apos;s assets again</source>
        <translation>installieren Sie die mitgelieferten Dateien der Software neu</translation>
    </message>
    <message>
        <source>a version in use is never edited: raise the version of the changed file</source>
        <translation>eine verwendete Version wird nie bearbeitet: Erhöhen Sie die Version der geänderten Datei</translation>
    </message>
    <message>
        <source>is outside the scale of the item (is %1)</source>
        <translation>liegt außerhalb der Skala des Punktes (ist %1)</translation>
    </message>
    <message>
        <source>use a rating from %1 to %2</source>
        <translation>verwenden Sie eine Bewertung von %1 bis %2</translation>
    </message>
    <message>
        <source>does not follow the anchor before it (is %1)</source>
        <translation>folgt nicht auf den Anker davor (ist %1)</translation>
    </message>
    <message>
        <source>list the anchors by rising rating, each rating once</source>
        <translation>ordnen Sie die Anker nach steigender Bewertung, jede Bewertung einmal</translation>
    </message>
    <message>
        <source>leaves an end of the scale without words</source>
        <translation>lässt ein Ende der Skala ohne Worte</translation>
    </message>
    <message>
        <source>describe the ratings %1 and %2</source>
        <translation>beschreiben Sie die Bewertungen %1 und %2</translation>
    </message>
    <message>
        <source>must be above /lowest (is %1)</source>
        <translation>muss über /lowest liegen (ist %1)</translation>
    </message>
    <message>
        <source>give the scale at least two ratings</source>
        <translation>geben Sie der Skala mindestens zwei Bewertungen</translation>
    </message>
    <message>
        <source>give every item its own id</source>
        <translation>geben Sie jedem Punkt eine eigene Kennung</translation>
    </message>
    <message>
        <source>raise the version of the changed file, or give it an id of its own</source>
        <translation>erhöhen Sie die Version der geänderten Datei, oder geben Sie ihr eine eigene Kennung</translation>
    </message>
    <message>
        <source>pass rule &apos;%1&apos;</source>
        <translation>Bestehensregel „%1“</translation>
    </message>
    <message>
        <source>write row:K, of:K,N or lc-cusum:P0,P1,H, such as lc-cusum:0.1,0.3,2.5</source>
        <translation>schreiben Sie row:K, of:K,N oder lc-cusum:P0,P1,H, zum Beispiel lc-cusum:0.1,0.3,2.5</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number</source>
        <translation>„%1“ ist keine Zahl</translation>
    </message>
    <message>
        <source>has %1 numbers where %2 are needed</source>
        <translation>hat %1 Zahlen, nötig sind %2</translation>
    </message>
    <message>
        <source>K and N must be whole numbers from 1 to %1</source>
        <translation>K und N müssen ganze Zahlen von 1 bis %1 sein</translation>
    </message>
    <message>
        <source>N must be at most %1</source>
        <translation>N darf höchstens %1 sein</translation>
    </message>
    <message>
        <source>K is larger than N</source>
        <translation>K ist größer als N</translation>
    </message>
    <message>
        <source>needs 0 &lt; P0 &lt; P1 &lt; 1</source>
        <translation>nötig ist 0 &lt; P0 &lt; P1 &lt; 1</translation>
    </message>
    <message>
        <source>H must be above 0 and at most 100</source>
        <translation>H muss über 0 und höchstens 100 sein</translation>
    </message>
    <message>
        <source>is not a rule</source>
        <translation>ist keine Regel</translation>
    </message>
    <message>
        <source>unknown name &quot;%1&quot;</source>
        <translation>unbekannter Name „%1“</translation>
    </message>
    <message>
        <source>not a list</source>
        <translation>ist keine Liste</translation>
    </message>
    <message>
        <source>give the metrics array of an attempt</source>
        <translation>geben Sie die Liste metrics eines Versuchs an</translation>
    </message>
    <message>
        <source>give every key of a metric row</source>
        <translation>geben Sie jeden Schlüssel einer Kennzahlzeile an</translation>
    </message>
    <message>
        <source>operator</source>
        <translation>Operateur</translation>
    </message>
    <message>
        <source>there is no model of this class of devices</source>
        <translation>für diese Geräteklasse gibt es kein Modell</translation>
    </message>
    <message>
        <source>use haptic, synthetic, tracked, controller or mouse-keyboard</source>
        <translation>verwenden Sie haptic, synthetic, tracked, controller oder mouse-keyboard</translation>
    </message>
    <message>
        <source>an operator does not perform goals of different parts of a scene in one task</source>
        <translation>ein simulierter Operateur führt nicht Schritte an verschiedenen Teilen einer Szene in einer Aufgabe durch</translation>
    </message>
    <message>
        <source>choose a task whose goals are all of one site</source>
        <translation>wählen Sie eine Aufgabe, deren Schritte alle am selben Ort liegen</translation>
    </message>
    <message>
        <source>no operator of this name</source>
        <translation>es gibt keinen Operateur dieses Namens</translation>
    </message>
    <message>
        <source>a sheet is divided with a grasper and a blade</source>
        <translation>eine Gewebeplatte wird mit einer Fasszange und einer Klinge durchtrennt</translation>
    </message>
    <message>
        <source>give one hand a grasper and the other scissors or a hook</source>
        <translation>geben Sie einer Hand eine Fasszange und der anderen eine Schere oder einen Haken</translation>
    </message>
    <message>
        <source>an operator does not hold the scope and instruments at once</source>
        <translation>ein simulierter Operateur hält nicht zugleich Optik und Instrumente</translation>
    </message>
    <message>
        <source>choose a task without instruments</source>
        <translation>wählen Sie eine Aufgabe ohne Instrumente</translation>
    </message>
    <message>
        <source>the scene gives the %1 hand no instrument</source>
        <translation>die %1 Hand hat in der Szene kein Instrument</translation>
    </message>
    <message>
        <source>add a grasper to the scene</source>
        <translation>fügen Sie der Szene eine Fasszange hinzu</translation>
    </message>
    <message>
        <source>give a pathology report as the program writes it</source>
        <translation>geben Sie einen Pathologiebericht an, wie die Software ihn schreibt</translation>
    </message>
    <message>
        <source>unknown metric &apos;%1&apos;</source>
        <translation>unbekannte Kennzahl „%1“</translation>
    </message>
    <message>
        <source>give the id of a metric</source>
        <translation>geben Sie die Kennung einer Kennzahl an</translation>
    </message>
    <message>
        <source>unit &apos;%1&apos; of a metric in &apos;%2&apos;</source>
        <translation>Einheit „%1“ bei einer Kennzahl in „%2“</translation>
    </message>
    <message>
        <source>build the set again</source>
        <translation>erstellen Sie den Satz neu</translation>
    </message>
    <message>
        <source>version %1 where the program computes version %2</source>
        <translation>Version %1, die Software berechnet Version %2</translation>
    </message>
    <message>
        <source>not the scale of the metric</source>
        <translation>ist nicht die Skala der Kennzahl</translation>
    </message>
    <message>
        <source>neither a deviation above 0 nor an absolute limit</source>
        <translation>weder eine Abweichung über 0 noch eine absolute Grenze</translation>
    </message>
    <message>
        <source>give the deviation, or the worst expert value as absolute_limit</source>
        <translation>geben Sie die Abweichung an, oder den schlechtesten Expertenwert als absolute_limit</translation>
    </message>
    <message>
        <source>the level of &apos;%1&apos; is given twice</source>
        <translation>der Wert für „%1“ ist doppelt angegeben</translation>
    </message>
    <message>
        <source>a provisional set takes over no limits of its task</source>
        <translation>ein vorläufiger Satz übernimmt keine Grenzwerte seiner Aufgabe</translation>
    </message>
    <message>
        <source>build the set of attempts that people performed</source>
        <translation>bilden Sie den Satz aus Versuchen, die Personen durchgeführt haben</translation>
    </message>
    <message>
        <source>the limit of &apos;%1&apos; is taken over twice</source>
        <translation>der Grenzwert für „%1“ ist doppelt übernommen</translation>
    </message>
    <message>
        <source>remove one</source>
        <translation>entfernen Sie einen davon</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is context only</source>
        <translation>„%1“ dient nur der Einordnung</translation>
    </message>
    <message>
        <source>gate a metric that is better in one direction</source>
        <translation>machen Sie eine Kennzahl zum Kriterium, die in einer Richtung besser ist</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is context in this task</source>
        <translation>„%1“ dient in dieser Aufgabe nur der Einordnung</translation>
    </message>
    <message>
        <source>remove it from context, or remove the gate</source>
        <translation>entfernen Sie sie aus context, oder entfernen Sie das Kriterium</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is measured for each hand</source>
        <translation>„%1“ wird je Hand gemessen</translation>
    </message>
    <message>
        <source>give hand left or right</source>
        <translation>geben Sie hand left oder right an</translation>
    </message>
    <message>
        <source>&apos;%1&apos; belongs to no single hand</source>
        <translation>„%1“ gehört zu keiner einzelnen Hand</translation>
    </message>
    <message>
        <source>remove hand</source>
        <translation>entfernen Sie hand</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no rows by tissue</source>
        <translation>„%1“ hat keine Zeilen je Gewebe</translation>
    </message>
    <message>
        <source>remove tissue</source>
        <translation>entfernen Sie tissue</translation>
    </message>
    <message>
        <source>more than %1 benchmark gates</source>
        <translation>mehr als %1 Kriterien mit Richtwert</translation>
    </message>
    <message>
        <source>show the others without a gate</source>
        <translation>zeigen Sie die übrigen ohne Kriterium</translation>
    </message>
    <message>
        <source>the scene &quot;%1&quot; has no targets to touch</source>
        <translation>die Szene „%1“ hat keine Ziele zum Berühren</translation>
    </message>
    <message>
        <source>add &quot;targets&quot; to the scene or name another scene</source>
        <translation>fügen Sie der Szene &quot;targets&quot; hinzu, oder nennen Sie eine andere Szene</translation>
    </message>
    <message>
        <source>the scene &quot;%1&quot; has no bowel</source>
        <translation>die Szene „%1“ hat keinen Darm</translation>
    </message>
    <message>
        <source>add &quot;bowel&quot; to the scene or name another scene</source>
        <translation>fügen Sie der Szene &quot;bowel&quot; hinzu, oder nennen Sie eine andere Szene</translation>
    </message>
    <message>
        <source>the scene &quot;%1&quot; has no sheet to divide</source>
        <translation>die Szene „%1“ hat keine Gewebeplatte zum Durchtrennen</translation>
    </message>
    <message>
        <source>add &quot;sheet&quot; or &quot;septa&quot; to the scene or name another scene</source>
        <translation>fügen Sie der Szene &quot;sheet&quot; oder &quot;septa&quot; hinzu, oder nennen Sie eine andere Szene</translation>
    </message>
    <message>
        <source>the scene &quot;%1&quot; has no bands</source>
        <translation>die Szene „%1“ hat keine Stränge</translation>
    </message>
    <message>
        <source>add &quot;bands&quot; to the scene or name another scene</source>
        <translation>fügen Sie der Szene &quot;bands&quot; hinzu, oder nennen Sie eine andere Szene</translation>
    </message>
    <message>
        <source>the scene &quot;%1&quot; has no objects to hand over</source>
        <translation>die Szene „%1“ hat keine Objekte zum Übergeben</translation>
    </message>
    <message>
        <source>add &quot;objects&quot; to the scene or name another scene</source>
        <translation>fügen Sie der Szene &quot;objects&quot; hinzu, oder nennen Sie eine andere Szene</translation>
    </message>
    <message>
        <source>the scene &quot;%1&quot; has no targets for the camera</source>
        <translation>die Szene „%1“ hat keine Ziele für die Kamera</translation>
    </message>
    <message>
        <source>add &quot;camera_targets&quot; to the scene or name another scene</source>
        <translation>fügen Sie der Szene &quot;camera_targets&quot; hinzu, oder nennen Sie eine andere Szene</translation>
    </message>
    <message>
        <source>the goal asks for more bands or vessels than the scene has</source>
        <translation>der Schritt verlangt mehr Stränge oder Gefäße, als die Szene hat</translation>
    </message>
    <message>
        <source>lower &quot;count&quot; or raise the scene&apos;s</source>
        <translation>senken Sie &quot;count&quot;, oder erhöhen Sie den Wert der Szene</translation>
    </message>
    <message>
        <source>give less than 1, such as 0.2</source>
        <translation>geben Sie weniger als 1 an, zum Beispiel 0.2</translation>
    </message>
    <message>
        <source>the goal asks for more targets than the scene has</source>
        <translation>der Schritt verlangt mehr Ziele, als die Szene hat</translation>
    </message>
    <message>
        <source>lower &quot;count&quot; or raise &quot;count&quot; of the scene&apos;s camera_targets</source>
        <translation>senken Sie &quot;count&quot;, oder erhöhen Sie &quot;count&quot; der camera_targets der Szene</translation>
    </message>
    <message>
        <source>the stretch of bowel has no length</source>
        <translation>der Darmabschnitt hat keine Länge</translation>
    </message>
    <message>
        <source>give from_m below to_m</source>
        <translation>geben Sie from_m kleiner als to_m an</translation>
    </message>
    <message>
        <source>minimum_step_m is not below maximum_step_m</source>
        <translation>minimum_step_m ist nicht kleiner als maximum_step_m</translation>
    </message>
    <message>
        <source>give the shortest step first</source>
        <translation>geben Sie zuerst den kürzesten Griff an</translation>
    </message>
    <message>
        <source>there are only %1 m between from_m and to_m</source>
        <translation>zwischen from_m und to_m liegen nur %1 m</translation>
    </message>
    <message>
        <source>ask for less, or move from_m and to_m apart</source>
        <translation>verlangen Sie weniger, oder legen Sie from_m und to_m weiter auseinander</translation>
    </message>
    <message>
        <source>the goal reaches beyond the bowel&apos;s end</source>
        <translation>der Schritt reicht über das Ende des Darms hinaus</translation>
    </message>
    <message>
        <source>keep from_m and to_m below the bowel&apos;s length</source>
        <translation>halten Sie from_m und to_m unter der Länge des Darms</translation>
    </message>
    <message>
        <source>traction_low_n_m is not below traction_high_n_m</source>
        <translation>traction_low_n_m ist nicht kleiner als traction_high_n_m</translation>
    </message>
    <message>
        <source>give the least traction first</source>
        <translation>geben Sie zuerst den kleinsten Zug an</translation>
    </message>
    <message>
        <source>tolerance_m is above corridor_m</source>
        <translation>tolerance_m liegt über corridor_m</translation>
    </message>
    <message>
        <source>give the smaller distance as tolerance_m</source>
        <translation>geben Sie den kleineren Abstand als tolerance_m an</translation>
    </message>
    <message>
        <source>the goal asks for more than the marked line&apos;s length</source>
        <translation>der Schritt verlangt mehr als die Länge der markierten Linie</translation>
    </message>
    <message>
        <source>lower &quot;length_m&quot; or raise &quot;line_length&quot; of the scene</source>
        <translation>senken Sie &quot;length_m&quot;, oder erhöhen Sie &quot;line_length&quot; der Szene</translation>
    </message>
    <message>
        <source>add one to the scene</source>
        <translation>fügen Sie der Szene eines hinzu</translation>
    </message>
    <message>
        <source>the goal asks for more targets than the scene has for a hand</source>
        <translation>der Schritt verlangt mehr Ziele, als die Szene für eine Hand hat</translation>
    </message>
    <message>
        <source>lower &quot;count&quot; or raise &quot;per_hand&quot; of the scene</source>
        <translation>senken Sie &quot;count&quot;, oder erhöhen Sie &quot;per_hand&quot; der Szene</translation>
    </message>
    <message>
        <source>a ring at this height still touches the tray</source>
        <translation>ein Ring berührt in dieser Höhe noch das Tablett</translation>
    </message>
    <message>
        <source>give at least 0.005, the height from which a fall counts as a drop</source>
        <translation>geben Sie mindestens 0.005 an, die Höhe, ab der ein Fall als Fallenlassen zählt</translation>
    </message>
    <message>
        <source>the goal asks for more rings than the scene has</source>
        <translation>der Schritt verlangt mehr Ringe, als die Szene hat</translation>
    </message>
    <message>
        <source>lower &quot;count&quot; or raise &quot;count&quot; of the scene&apos;s objects</source>
        <translation>senken Sie &quot;count&quot;, oder erhöhen Sie &quot;count&quot; der objects der Szene</translation>
    </message>
    <message>
        <source>the %1 hand cannot grasp a ring</source>
        <translation>die %1 Hand kann keinen Ring greifen</translation>
    </message>
    <message>
        <source>give both hands of the scene a grasper</source>
        <translation>geben Sie beiden Händen der Szene eine Fasszange</translation>
    </message>
    <message>
        <source>the scene &quot;%1&quot; has no septa to make a specimen of</source>
        <translation>die Szene „%1“ hat keine Septen, aus denen ein Präparat entsteht</translation>
    </message>
    <message>
        <source>add &quot;septa&quot; to the scene or remove &quot;pathology&quot;</source>
        <translation>fügen Sie der Szene &quot;septa&quot; hinzu, oder entfernen Sie &quot;pathology&quot;</translation>
    </message>
    <message>
        <source>the task divides no line</source>
        <translation>die Aufgabe durchtrennt keine Linie</translation>
    </message>
    <message>
        <source>add a goal of kind divide_line or remove it</source>
        <translation>fügen Sie einen Schritt der Art divide_line hinzu, oder entfernen Sie es</translation>
    </message>
    <message>
        <source>the scene has only %1 septa, counted from 0</source>
        <translation>die Szene hat nur %1 Septen, gezählt ab 0</translation>
    </message>
    <message>
        <source>give a lower level</source>
        <translation>geben Sie eine niedrigere Höhe an</translation>
    </message>
    <message>
        <source>the tumour grows through the whole mesorectum</source>
        <translation>der Tumor wächst durch das ganze Mesorektum</translation>
    </message>
    <message>
        <source>keep depth_m below the height of the fat</source>
        <translation>halten Sie depth_m unter der Höhe des Fetts</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not the name of a scene file</source>
        <translation>„%1“ ist nicht der Name einer Szenendatei</translation>
    </message>
    <message>
        <source>give a file name of assets/scenes, such as a2_targets.json</source>
        <translation>geben Sie einen Dateinamen aus assets/scenes an, zum Beispiel a2_targets.json</translation>
    </message>
    <message>
        <source>the variant &quot;%1&quot; or its scene is given twice</source>
        <translation>die Variante „%1“ oder ihre Szene ist doppelt angegeben</translation>
    </message>
    <message>
        <source>give every variant an id and a scene of its own</source>
        <translation>geben Sie jeder Variante eine eigene Kennung und eine eigene Szene</translation>
    </message>
    <message>
        <source>is not the standard variant</source>
        <translation>ist nicht die Standardvariante</translation>
    </message>
    <message>
        <source>list &quot;%1&quot; with the task&apos;s own scene first</source>
        <translation>führen Sie „%1“ mit der eigenen Szene der Aufgabe zuerst auf</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a variant with sets of its own</source>
        <translation>„%1“ ist keine Variante mit eigenen Richtwertsätzen</translation>
    </message>
    <message>
        <source>name a variant of this task that has no other family, or remove the key</source>
        <translation>nennen Sie eine Variante dieser Aufgabe ohne andere Familie, oder entfernen Sie den Schlüssel</translation>
    </message>
    <message>
        <source>the metric &quot;%1&quot; is given twice</source>
        <translation>die Kennzahl „%1“ ist doppelt angegeben</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not among the metrics</source>
        <translation>„%1“ gehört nicht zu den Kennzahlen</translation>
    </message>
    <message>
        <source>name a metric of this task, alone or with .left or .right</source>
        <translation>nennen Sie eine Kennzahl dieser Aufgabe, allein oder mit .left oder .right</translation>
    </message>
    <message>
        <source>the goal &quot;%1&quot; is given twice</source>
        <translation>der Schritt „%1“ ist doppelt angegeben</translation>
    </message>
    <message>
        <source>give every goal its own id</source>
        <translation>geben Sie jedem Schritt eine eigene Kennung</translation>
    </message>
    <message>
        <source>a goal of kind %1 needs &quot;%2&quot;</source>
        <translation>ein Schritt der Art %1 braucht &quot;%2&quot;</translation>
    </message>
    <message>
        <source>add it: %1</source>
        <translation>fügen Sie es hinzu: %1</translation>
    </message>
    <message>
        <source>show the metric without gating it, or make the gate absolute</source>
        <translation>zeigen Sie die Kennzahl ohne Kriterium, oder machen Sie das Kriterium absolut</translation>
    </message>
    <message>
        <source>the gate&apos;s metric &quot;%1&quot; is not among the task&apos;s metrics</source>
        <translation>die Kennzahl „%1“ des Kriteriums gehört nicht zu den Kennzahlen der Aufgabe</translation>
    </message>
    <message>
        <source>add it to &quot;metrics&quot; or correct its id</source>
        <translation>fügen Sie sie zu &quot;metrics&quot; hinzu, oder berichtigen Sie ihre Kennung</translation>
    </message>
    <message>
        <source>the gate on &quot;%1&quot; is given twice</source>
        <translation>das Kriterium zu „%1“ ist doppelt angegeben</translation>
    </message>
    <message>
        <source>remove one, or give it another hand or tissue</source>
        <translation>entfernen Sie eines, oder geben Sie ihm eine andere Hand oder ein anderes Gewebe</translation>
    </message>
    <message>
        <source>an absolute gate without limit and limit_source</source>
        <translation>ein absolutes Kriterium ohne limit und limit_source</translation>
    </message>
    <message>
        <source>add both: the value and where it comes from</source>
        <translation>fügen Sie beides hinzu: den Wert und woher er kommt</translation>
    </message>
    <message>
        <source>a benchmark gate with a limit of its own</source>
        <translation>ein Kriterium mit Richtwert, das eine eigene Grenze hat</translation>
    </message>
    <message>
        <source>remove it (the benchmark set gives it) or make the gate absolute</source>
        <translation>entfernen Sie sie (der Richtwertsatz liefert sie), oder machen Sie das Kriterium absolut</translation>
    </message>
    <message>
        <source>task %1</source>
        <translation>Aufgabe %1</translation>
    </message>
    <message>
        <source>attempts with %1 are not assessed, they are practice only</source>
        <translation>Versuche mit %1 werden nicht bewertet, sie sind nur Übung</translation>
    </message>
    <message>
        <source>the curriculum %1 does not count attempts with %2, they are practice only</source>
        <translation>das Curriculum %1 zählt Versuche mit %2 nicht, sie sind nur Übung</translation>
    </message>
    <message>
        <source>practise, or use one of: %1</source>
        <translation>üben Sie, oder verwenden Sie eines von: %1</translation>
    </message>
    <message>
        <source>has no variant &quot;%1&quot;</source>
        <translation>hat keine Variante „%1“</translation>
    </message>
    <message>
        <source>choose one of these: %1</source>
        <translation>wählen Sie eine von diesen: %1</translation>
    </message>
    <message>
        <source>longer than %1 bytes</source>
        <translation>ist länger als %1 Bytes</translation>
    </message>
    <message>
        <source>the row of %1 is missing</source>
        <translation>die Zeile mit %1 fehlt</translation>
    </message>
    <message>
        <source>write t,event,hand,tissue,value,detail, then s,-,-,-,event,event</source>
        <translation>schreiben Sie t,event,hand,tissue,value,detail, dann s,-,-,-,event,event</translation>
    </message>
    <message>
        <source>these are not the %1 of an events file</source>
        <translation>das sind nicht die %1 einer Ereignisdatei</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 ist keine Zahl</translation>
    </message>
    <message>
        <source>write a whole number</source>
        <translation>schreiben Sie eine ganze Zahl</translation>
    </message>
    <message>
        <source>write a number</source>
        <translation>schreiben Sie eine Zahl</translation>
    </message>
    <message>
        <source>write a number from %1 to %2</source>
        <translation>schreiben Sie eine Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>%1 is not a hand</source>
        <translation>%1 ist keine Hand</translation>
    </message>
    <message>
        <source>write left, right or nothing</source>
        <translation>schreiben Sie left, right oder nichts</translation>
    </message>
    <message>
        <source>%1 is not a tissue of this task</source>
        <translation>%1 ist kein Gewebe dieser Aufgabe</translation>
    </message>
    <message>
        <source>write a label of the task&apos;s scene or of the trace, or nothing</source>
        <translation>schreiben Sie einen Gewebenamen aus der Szene der Aufgabe oder der Aufzeichnung, oder nichts</translation>
    </message>
    <message>
        <source>%1 is not an event</source>
        <translation>%1 ist kein Ereignis</translation>
    </message>
    <message>
        <source>write a name from docs/FORMATS.md, such as grasp</source>
        <translation>schreiben Sie einen Namen aus docs/FORMATS.md, zum Beispiel grasp</translation>
    </message>
    <message>
        <source>%1 cells where there are %2</source>
        <translation>%1 Zellen, wo %2 stehen müssen</translation>
    </message>
    <message>
        <source>write t,event,hand,tissue,value,detail</source>
        <translation>schreiben Sie t,event,hand,tissue,value,detail</translation>
    </message>
    <message>
        <source>more than %1 events</source>
        <translation>mehr als %1 Ereignisse</translation>
    </message>
    <message>
        <source>sort the rows by time</source>
        <translation>ordnen Sie die Zeilen nach der Zeit</translation>
    </message>
    <message>
        <source>check the path and its permissions</source>
        <translation>prüfen Sie den Pfad und die Rechte daran</translation>
    </message>
    <message>
        <source>the cell is empty</source>
        <translation>die Zelle ist leer</translation>
    </message>
    <message>
        <source>%1 is not a finite number</source>
        <translation>%1 ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>leave the sample out or give the value</source>
        <translation>lassen Sie den Messwert weg, oder geben Sie den Wert an</translation>
    </message>
    <message>
        <source>not of length one (%1)</source>
        <translation>hat nicht die Länge eins (%1)</translation>
    </message>
    <message>
        <source>normalise it</source>
        <translation>normieren Sie ihn</translation>
    </message>
    <message>
        <source>give t in seconds since the attempt began, at most 2 h</source>
        <translation>geben Sie t in Sekunden seit dem Beginn des Versuchs an, höchstens 2 h</translation>
    </message>
    <message>
        <source>give positions in metres</source>
        <translation>geben Sie Positionen in Metern an</translation>
    </message>
    <message>
        <source>give components of a unit vector or quaternion</source>
        <translation>geben Sie Komponenten eines Einheitsvektors oder einer Quaternion an</translation>
    </message>
    <message>
        <source>give angles in radians</source>
        <translation>geben Sie Winkel in Radiant an</translation>
    </message>
    <message>
        <source>give forces in newtons</source>
        <translation>geben Sie Kräfte in Newton an</translation>
    </message>
    <message>
        <source>give torques in newton metres</source>
        <translation>geben Sie Drehmomente in Newtonmetern an</translation>
    </message>
    <message>
        <source>give areas in square metres</source>
        <translation>geben Sie Flächen in Quadratmetern an</translation>
    </message>
    <message>
        <source>write 1 or 0</source>
        <translation>schreiben Sie 1 oder 0</translation>
    </message>
    <message>
        <source>write a label or leave the cell empty</source>
        <translation>schreiben Sie einen Namen, oder lassen Sie die Zelle leer</translation>
    </message>
    <message>
        <source>write a whole number from -1 to 32767</source>
        <translation>schreiben Sie eine ganze Zahl von -1 bis 32767</translation>
    </message>
    <message>
        <source>%1 is not a tissue label</source>
        <translation>%1 ist kein Name eines Gewebes</translation>
    </message>
    <message>
        <source>use UTF-8 text of at most %1 bytes</source>
        <translation>verwenden Sie UTF-8-Text von höchstens %1 Bytes</translation>
    </message>
    <message>
        <source>more than %1 different labels</source>
        <translation>mehr als %1 verschiedene Namen</translation>
    </message>
    <message>
        <source>%1 is not a whole number</source>
        <translation>%1 ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>write a row of names, a row of units, then the samples</source>
        <translation>schreiben Sie eine Zeile mit Namen, eine Zeile mit Einheiten, dann die Messwerte</translation>
    </message>
    <message>
        <source>%1 columns</source>
        <translation>%1 Spalten</translation>
    </message>
    <message>
        <source>write at most %1</source>
        <translation>schreiben Sie höchstens %1</translation>
    </message>
    <message>
        <source>the column is missing</source>
        <translation>die Spalte fehlt</translation>
    </message>
    <message>
        <source>add t, the time in seconds</source>
        <translation>fügen Sie t hinzu, die Zeit in Sekunden</translation>
    </message>
    <message>
        <source>the row of units is missing</source>
        <translation>die Zeile mit den Einheiten fehlt</translation>
    </message>
    <message>
        <source>write the units in row 2 (s, m, N, rad, m2, -)</source>
        <translation>schreiben Sie die Einheiten in Zeile 2 (s, m, N, rad, m2, -)</translation>
    </message>
    <message>
        <source>%1 cells where the header has %2</source>
        <translation>%1 Zellen, die Kopfzeile hat %2</translation>
    </message>
    <message>
        <source>give every column its unit</source>
        <translation>geben Sie jeder Spalte ihre Einheit</translation>
    </message>
    <message>
        <source>unit %1 where &apos;%2&apos; is needed</source>
        <translation>Einheit %1, nötig ist „%2“</translation>
    </message>
    <message>
        <source>convert the column to %1 and write the unit in row 2</source>
        <translation>rechnen Sie die Spalte in %1 um, und schreiben Sie die Einheit in Zeile 2</translation>
    </message>
    <message>
        <source>there is a blank line before it</source>
        <translation>davor steht eine leere Zeile</translation>
    </message>
    <message>
        <source>more than %1 samples</source>
        <translation>mehr als %1 Messwerte</translation>
    </message>
    <message>
        <source>split the trace</source>
        <translation>teilen Sie die Aufzeichnung auf</translation>
    </message>
    <message>
        <source>no sample follows the units</source>
        <translation>nach den Einheiten folgt kein Messwert</translation>
    </message>
    <message>
        <source>unit &quot;%1&quot; where one of %2 is needed</source>
        <translation>Einheit „%1“, nötig ist eine von %2</translation>
    </message>
    <message>
        <source>give the unit that the file has</source>
        <translation>geben Sie die Einheit an, die in der Datei steht</translation>
    </message>
    <message>
        <source>is not a column of a trace</source>
        <translation>ist keine Spalte einer Aufzeichnung</translation>
    </message>
    <message>
        <source>see the table of columns in docs/FORMATS.md</source>
        <translation>siehe die Spaltentabelle in docs/FORMATS.md</translation>
    </message>
    <message>
        <source>is a name, but the file has no row of names</source>
        <translation>ist ein Name, aber die Datei hat keine Zeile mit Namen</translation>
    </message>
    <message>
        <source>give the number of the column, from 1, or raise header_rows</source>
        <translation>geben Sie die Nummer der Spalte an, ab 1, oder erhöhen Sie header_rows</translation>
    </message>
    <message>
        <source>has no meaning for this column</source>
        <translation>hat bei dieser Spalte keine Bedeutung</translation>
    </message>
    <message>
        <source>the columns have a time already</source>
        <translation>die Spalten haben schon eine Zeit</translation>
    </message>
    <message>
        <source>remove rate_hz or the column t</source>
        <translation>entfernen Sie rate_hz oder die Spalte t</translation>
    </message>
    <message>
        <source>there is no time</source>
        <translation>es gibt keine Zeit</translation>
    </message>
    <message>
        <source>map the column t or give rate_hz</source>
        <translation>ordnen Sie die Spalte t zu, oder geben Sie rate_hz an</translation>
    </message>
    <message>
        <source>%1 cells, but column %2 is mapped</source>
        <translation>%1 Zellen, zugeordnet ist aber die Spalte %2</translation>
    </message>
    <message>
        <source>check separator and columns of the mapping</source>
        <translation>prüfen Sie separator und columns der Zuordnung</translation>
    </message>
    <message>
        <source>the file has no sample</source>
        <translation>die Datei enthält keinen Messwert</translation>
    </message>
    <message>
        <source>check header_rows and missing of the mapping</source>
        <translation>prüfen Sie header_rows und missing der Zuordnung</translation>
    </message>
    <message>
        <source>the file ends in its header</source>
        <translation>die Datei endet in ihrem Kopf</translation>
    </message>
    <message>
        <source>check header_rows of the mapping</source>
        <translation>prüfen Sie header_rows der Zuordnung</translation>
    </message>
    <message>
        <source>the column is not in the file</source>
        <translation>die Spalte ist nicht in der Datei</translation>
    </message>
    <message>
        <source>correct its name in the mapping</source>
        <translation>berichtigen Sie ihren Namen in der Zuordnung</translation>
    </message>
    <message>
        <source>more than 2 h after the first sample</source>
        <translation>mehr als 2 h nach dem ersten Messwert</translation>
    </message>
    <message>
        <source>the attempt is still running</source>
        <translation>der Versuch läuft noch</translation>
    </message>
    <message>
        <source>wait for its end</source>
        <translation>warten Sie sein Ende ab</translation>
    </message>
    <message>
        <source>the attempt is voided already</source>
        <translation>der Versuch ist schon für ungültig erklärt</translation>
    </message>
    <message>
        <source>the attempt continues another one and is never scored</source>
        <translation>der Versuch setzt einen anderen fort und wird nie ausgewertet</translation>
    </message>
    <message>
        <source>score an attempt from its beginning</source>
        <translation>werten Sie einen Versuch von Anfang an aus</translation>
    </message>
    <message>
        <source>name the person who performed it</source>
        <translation>nennen Sie die Person, die ihn durchgeführt hat</translation>
    </message>
    <message>
        <source>no attempt %1</source>
        <translation>es gibt keinen Versuch %1</translation>
    </message>
    <message>
        <source>list the attempts and name one of them</source>
        <translation>lassen Sie sich die Versuche auflisten, und nennen Sie einen davon</translation>
    </message>
    <message>
        <source>%1: %2 chunk %3 of attempt %4: %5</source>
        <translation>%1: Block %3 (%2) des Versuchs %4: %5</translation>
    </message>
    <message>
        <source>%1: the record of attempt %2 has %3 of its %4 events: a part of it is missing</source>
        <translation>%1: Die Aufzeichnung des Versuchs %2 hat %3 ihrer %4 Ereignisse: Ein Teil fehlt</translation>
    </message>
    <message>
        <source>restore the newest backup</source>
        <translation>stellen Sie die neueste Sicherung wieder her</translation>
    </message>
    <message>
        <source>%1: the record of attempt %2 has %3 samples for %4 inputs: a part of it is missing</source>
        <translation>%1: Die Aufzeichnung des Versuchs %2 hat %3 Messwerte für %4 Eingaben: Ein Teil fehlt</translation>
    </message>
    <message>
        <source>%1: the state that attempt %2 began with does not match its checksum</source>
        <translation>%1: Der Zustand, mit dem der Versuch %2 begann, passt nicht zu seiner Prüfsumme</translation>
    </message>
    <message>
        <source>%1: the scene of attempt %2 is damaged</source>
        <translation>%1: Die Szene des Versuchs %2 ist beschädigt</translation>
    </message>
    <message>
        <source>%1: product %2 of attempt %3 is damaged</source>
        <translation>%1: Das Ergebnis %2 des Versuchs %3 ist beschädigt</translation>
    </message>
    <message>
        <source>%1 is not an educator</source>
        <translation>%1 ist kein Ausbilder</translation>
    </message>
    <message>
        <source>have an administrator give them the role first</source>
        <translation>lassen Sie ihr zuerst von einem Administrator die Rolle geben</translation>
    </message>
    <message>
        <source>no cohort %1</source>
        <translation>es gibt keine Gruppe %1</translation>
    </message>
    <message>
        <source>list the cohorts and name one of them</source>
        <translation>lassen Sie sich die Gruppen auflisten, und nennen Sie eine davon</translation>
    </message>
    <message>
        <source>a cohort &quot;%1&quot; exists</source>
        <translation>es gibt schon eine Gruppe „%1“</translation>
    </message>
    <message>
        <source>choose another name</source>
        <translation>wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>no curriculum %1 is installed</source>
        <translation>das Curriculum %1 ist nicht installiert</translation>
    </message>
    <message>
        <source>name one of these: %1</source>
        <translation>nennen Sie eines von diesen: %1</translation>
    </message>
    <message>
        <source>nothing can be said of a standing: the person follows the curriculum %1, which is not at this station</source>
        <translation>zu einem Stand lässt sich nichts sagen: Die Person folgt dem Curriculum %1, das an dieser Station fehlt</translation>
    </message>
    <message>
        <source>%1 is not a task of the curriculum %2, which the person follows</source>
        <translation>%1 ist keine Aufgabe des Curriculums %2, dem die Person folgt</translation>
    </message>
    <message>
        <source>name one of its tasks, or move the person to a version that has this one first</source>
        <translation>nennen Sie eine seiner Aufgaben, oder stellen Sie die Person zuerst auf eine Version um, die diese hat</translation>
    </message>
    <message>
        <source>the decision would change nothing: %1 is not locked</source>
        <translation>die Entscheidung würde nichts ändern: %1 ist nicht gesperrt</translation>
    </message>
    <message>
        <source>nothing has to be decided: the person can perform assessed attempts of it</source>
        <translation>es ist nichts zu entscheiden: Die Person kann bewertete Versuche durchführen</translation>
    </message>
    <message>
        <source>the decision would change nothing: the person is proficient in %1, and no check is due</source>
        <translation>die Entscheidung würde nichts ändern: Die Person beherrscht %1 sicher, und keine Kontrolle ist fällig</translation>
    </message>
    <message>
        <source>decide again when the next check is due</source>
        <translation>entscheiden Sie wieder, wenn die nächste Kontrolle fällig ist</translation>
    </message>
    <message>
        <source>exchange with the programme server, or install it (a newer version of the program, or the file that was published at another station)</source>
        <translation>gleichen Sie mit dem Server des Programms ab oder installieren Sie es (eine neuere Version von Fulcrum oder die Datei, die an einer anderen Station veröffentlicht wurde)</translation>
    </message>
    <message>
        <source>no certificate with this code was found, but of people who follow a curriculum that is not at this station none can be looked at (how many: %1)</source>
        <translation>kein Zertifikat mit diesem Code gefunden; die der Personen, deren Curriculum an dieser Station fehlt, lassen sich aber nicht ansehen (Anzahl: %1)</translation>
    </message>
    <message>
        <source>a version in use is never edited: restore this file, write the change to a new file with /version raised, and move people with fulcrum curriculum move</source>
        <translation>eine verwendete Version wird nie bearbeitet: Stellen Sie diese Datei wieder her, schreiben Sie die Änderung in eine neue Datei mit höherer /version, und stellen Sie Personen mit fulcrum curriculum move um</translation>
    </message>
    <message>
        <source>the login &quot;%1&quot; cannot be used</source>
        <translation>der Anmeldename „%1“ kann nicht verwendet werden</translation>
    </message>
    <message>
        <source>logins that begin with synthetic- or external- belong to simulated people</source>
        <translation>Anmeldenamen, die mit synthetic- oder external- beginnen, gehören simulierten Personen</translation>
    </message>
    <message>
        <source>use 1 to 64 letters, digits or . _ - @, and not &quot;station&quot;</source>
        <translation>verwenden Sie 1 bis 64 Buchstaben, Ziffern oder . _ - @, und nicht &quot;station&quot;</translation>
    </message>
    <message>
        <source>type it with letters, digits and punctuation only</source>
        <translation>geben Sie nur Buchstaben, Ziffern und Satzzeichen ein</translation>
    </message>
    <message>
        <source>use 1 to 120 characters</source>
        <translation>verwenden Sie 1 bis 120 Zeichen</translation>
    </message>
    <message>
        <source>the password is too short (or beyond 1,024 bytes)</source>
        <translation>das Passwort ist zu kurz (oder länger als 1024 Bytes)</translation>
    </message>
    <message>
        <source>use at least %1 characters</source>
        <translation>verwenden Sie mindestens %1 Zeichen</translation>
    </message>
    <message>
        <source>station is not the role of a person</source>
        <translation>station ist keine Rolle einer Person</translation>
    </message>
    <message>
        <source>choose trainee, educator, director or administrator</source>
        <translation>wählen Sie trainee, educator, director oder administrator</translation>
    </message>
    <message>
        <source>the login &quot;%1&quot; is taken</source>
        <translation>der Anmeldename „%1“ ist vergeben</translation>
    </message>
    <message>
        <source>no person %1</source>
        <translation>es gibt keine Person %1</translation>
    </message>
    <message>
        <source>list the people and name one of them</source>
        <translation>lassen Sie sich die Personen auflisten, und nennen Sie eine davon</translation>
    </message>
    <message>
        <source>by the program, in a demo store</source>
        <translation>nur die Software, in einer Vorführung</translation>
    </message>
    <message>
        <source>the demo takes practice attempts only</source>
        <translation>in der Vorführung sind nur Übungen möglich</translation>
    </message>
    <message>
        <source>delete the demo store to build it again</source>
        <translation>löschen Sie den Datenbestand der Vorführung, um sie neu aufzubauen</translation>
    </message>
    <message>
        <source>make someone else administrator first</source>
        <translation>machen Sie zuerst eine andere Person zum Administrator</translation>
    </message>
    <message>
        <source>make an account for a person</source>
        <translation>legen Sie ein Konto für eine Person an</translation>
    </message>
    <message>
        <source>the login &quot;%1&quot; is not one of a simulated person</source>
        <translation>der Anmeldename „%1“ gehört keiner simulierten Person</translation>
    </message>
    <message>
        <source>name a synthetic or external person of this store, or a new one whose login begins with synthetic- or external-; operators and traces may not perform for others</source>
        <translation>nennen Sie eine synthetische oder externe Person dieses Datenbestands, oder eine neue, deren Anmeldename mit synthetic- oder external- beginnt; simulierte Operateure und Aufzeichnungen dürfen nicht für andere eintreten</translation>
    </message>
    <message>
        <source>rating %1 has more answers than its form</source>
        <translation>die Beurteilung %1 hat mehr Antworten als ihr Bogen</translation>
    </message>
    <message>
        <source>no rating %1</source>
        <translation>es gibt keine Beurteilung %1</translation>
    </message>
    <message>
        <source>open the attempt again</source>
        <translation>öffnen Sie den Versuch noch einmal</translation>
    </message>
    <message>
        <source>someone else&apos;s form</source>
        <translation>der Bogen gehört einer anderen Person</translation>
    </message>
    <message>
        <source>the form was handed in already</source>
        <translation>der Bogen ist schon abgegeben</translation>
    </message>
    <message>
        <source>what was handed in is never changed</source>
        <translation>was abgegeben ist, wird nie geändert</translation>
    </message>
    <message>
        <source>the attempt is voided</source>
        <translation>der Versuch ist für ungültig erklärt</translation>
    </message>
    <message>
        <source>the attempt has not ended</source>
        <translation>der Versuch ist noch nicht beendet</translation>
    </message>
    <message>
        <source>rate an attempt that has ended and counts</source>
        <translation>beurteilen Sie einen Versuch, der beendet ist und zählt</translation>
    </message>
    <message>
        <source>the form %1 has another number of items</source>
        <translation>der Bogen %1 hat eine andere Zahl von Punkten</translation>
    </message>
    <message>
        <source>%1: %2 is outside the scale</source>
        <translation>%1: %2 liegt außerhalb der Skala</translation>
    </message>
    <message>
        <source>rate from %1 to %2</source>
        <translation>bewerten Sie von %1 bis %2</translation>
    </message>
    <message>
        <source>%1 must be rated</source>
        <translation>%1 muss bewertet werden</translation>
    </message>
    <message>
        <source>only optional items can be left as not seen</source>
        <translation>nur freiwillige Punkte dürfen als „nicht gesehen“ offen bleiben</translation>
    </message>
    <message>
        <source>a remark has at most 4,000 characters</source>
        <translation>eine Bemerkung hat höchstens 4000 Zeichen</translation>
    </message>
    <message>
        <source>shorten it</source>
        <translation>kürzen Sie sie</translation>
    </message>
    <message>
        <source>you handed in this form for this attempt already</source>
        <translation>Sie haben diesen Bogen für diesen Versuch schon abgegeben</translation>
    </message>
    <message>
        <source>complete that one, or choose another form</source>
        <translation>füllen Sie jenen fertig aus, oder wählen Sie einen anderen Bogen</translation>
    </message>
    <message>
        <source>%1 is not rated yet</source>
        <translation>%1 ist noch nicht bewertet</translation>
    </message>
    <message>
        <source>rate every item of the form</source>
        <translation>bewerten Sie jeden Punkt des Bogens</translation>
    </message>
    <message>
        <source>the attempt names no task</source>
        <translation>der Versuch nennt keine Aufgabe</translation>
    </message>
    <message>
        <source>give the task&apos;s id</source>
        <translation>geben Sie die Kennung der Aufgabe an</translation>
    </message>
    <message>
        <source>an attempt by %1 never belongs to a real person</source>
        <translation>ein Versuch durch %1 gehört nie einer echten Person</translation>
    </message>
    <message>
        <source>record it for a synthetic or external person</source>
        <translation>zeichnen Sie ihn für eine synthetische oder externe Person auf</translation>
    </message>
    <message>
        <source>choose practice, or make a programme</source>
        <translation>wählen Sie Übung, oder legen Sie ein Programm an</translation>
    </message>
    <message>
        <source>an attempt that continues another one is practice</source>
        <translation>ein Versuch, der einen anderen fortsetzt, ist eine Übung</translation>
    </message>
    <message>
        <source>choose practice</source>
        <translation>wählen Sie Übung</translation>
    </message>
    <message>
        <source>perform it as practice</source>
        <translation>führen Sie ihn als Übung durch</translation>
    </message>
    <message>
        <source>product %1 is larger than 64 MiB</source>
        <translation>das Ergebnis %1 ist größer als 64 MiB</translation>
    </message>
    <message>
        <source>store it coarser</source>
        <translation>speichern Sie es gröber</translation>
    </message>
    <message>
        <source>an attempt ends neither running nor voided</source>
        <translation>ein Versuch endet weder laufend noch ungültig</translation>
    </message>
    <message>
        <source>give the state in which it ended</source>
        <translation>geben Sie den Zustand an, in dem er endete</translation>
    </message>
    <message>
        <source>an attempt that continues another one is never scored</source>
        <translation>ein Versuch, der einen anderen fortsetzt, wird nie ausgewertet</translation>
    </message>
    <message>
        <source>finish it without a score</source>
        <translation>beenden Sie ihn ohne Bewertung</translation>
    </message>
    <message>
        <source>no comment %1</source>
        <translation>es gibt keinen Kommentar %1</translation>
    </message>
    <message>
        <source>a comment has 1 to 4,000 characters</source>
        <translation>ein Kommentar hat 1 bis 4000 Zeichen</translation>
    </message>
    <message>
        <source>write or shorten it</source>
        <translation>schreiben oder kürzen Sie ihn</translation>
    </message>
    <message>
        <source>a comment&apos;s time is not within the attempt</source>
        <translation>der Zeitpunkt eines Kommentars liegt nicht im Versuch</translation>
    </message>
    <message>
        <source>choose a time from 0 s on</source>
        <translation>wählen Sie einen Zeitpunkt ab 0 s</translation>
    </message>
    <message>
        <source>someone else&apos;s comment</source>
        <translation>der Kommentar gehört einer anderen Person</translation>
    </message>
    <message>
        <source>the comment was sent already</source>
        <translation>der Kommentar ist schon gesendet</translation>
    </message>
    <message>
        <source>too many wrong tries with this login; wait %1 s</source>
        <translation>zu viele Fehlversuche mit diesem Anmeldenamen; warten Sie %1 s</translation>
    </message>
    <message>
        <source>%1; you can try again in %2 s</source>
        <translation>%1; in %2 s können Sie es noch einmal versuchen</translation>
    </message>
    <message>
        <source>login or password wrong</source>
        <translation>Anmeldename oder Passwort falsch</translation>
    </message>
    <message>
        <source>this one-time password has expired (24 h); ask an administrator for another</source>
        <translation>dieses Einmalpasswort ist abgelaufen (24 h); bitten Sie einen Administrator um ein neues</translation>
    </message>
    <message>
        <source>a demo store holds no programme</source>
        <translation>eine Vorführung enthält kein Programm</translation>
    </message>
    <message>
        <source>make a store of your own</source>
        <translation>legen Sie einen eigenen Datenbestand an</translation>
    </message>
    <message>
        <source>this store has a programme and its administrator already</source>
        <translation>dieser Datenbestand hat schon ein Programm und einen Administrator</translation>
    </message>
    <message>
        <source>sign in</source>
        <translation>melden Sie sich an</translation>
    </message>
    <message>
        <source>this account holds no role; ask an administrator for one</source>
        <translation>dieses Konto hat keine Rolle; bitten Sie einen Administrator um eine</translation>
    </message>
    <message>
        <source>this account does not hold the role %1</source>
        <translation>dieses Konto hat die Rolle %1 nicht</translation>
    </message>
    <message>
        <source>demo people exist in the demo store only</source>
        <translation>Vorführkonten gibt es nur in der Vorführung</translation>
    </message>
    <message>
        <source>someone else&apos;s login</source>
        <translation>der Anmeldename gehört einer anderen Person</translation>
    </message>
    <message>
        <source>the new password is the old one</source>
        <translation>das neue Passwort ist das alte</translation>
    </message>
    <message>
        <source>synthetic and external people do not sign in</source>
        <translation>synthetische und externe Personen melden sich nicht an</translation>
    </message>
    <message>
        <source>name a person</source>
        <translation>nennen Sie eine Person</translation>
    </message>
    <message>
        <source>your own password is changed, not issued</source>
        <translation>das eigene Passwort wird geändert, nicht ausgegeben</translation>
    </message>
    <message>
        <source>login or recovery code wrong (the code is for the last administrator only)</source>
        <translation>Anmeldename oder Wiederherstellungscode falsch (der Code gilt nur für den letzten Administrator)</translation>
    </message>
    <message>
        <source>no task was named</source>
        <translation>es wurde keine Aufgabe genannt</translation>
    </message>
    <message>
        <source>name a task of the curriculum</source>
        <translation>nennen Sie eine Aufgabe des Curriculums</translation>
    </message>
    <message>
        <source>no reason was given</source>
        <translation>es wurde kein Grund angegeben</translation>
    </message>
    <message>
        <source>say in a few words why the values change</source>
        <translation>sagen Sie in wenigen Worten, warum sich die Werte ändern</translation>
    </message>
    <message>
        <source>%1: %2 is not a number</source>
        <translation>%1: %2 ist keine Zahl</translation>
    </message>
    <message>
        <source>give a number</source>
        <translation>geben Sie eine Zahl an</translation>
    </message>
    <message>
        <source>version %1 by %2 came into force in the meantime</source>
        <translation>inzwischen gilt die Version %1 von %2</translation>
    </message>
    <message>
        <source>look at its values and set yours again</source>
        <translation>sehen Sie sich deren Werte an, und setzen Sie Ihre noch einmal</translation>
    </message>
    <message>
        <source>these values are in force already</source>
        <translation>diese Werte gelten schon</translation>
    </message>
    <message>
        <source>change one of them</source>
        <translation>ändern Sie einen davon</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>name a file that exists and may be read</source>
        <translation>nennen Sie eine Datei, die es gibt und die Sie lesen dürfen</translation>
    </message>
    <message>
        <source>is larger than 16 MiB</source>
        <translation>ist größer als 16 MiB</translation>
    </message>
    <message>
        <source>is not UTF-8</source>
        <translation>ist nicht UTF-8</translation>
    </message>
    <message>
        <source>save it as UTF-8</source>
        <translation>speichern Sie sie als UTF-8</translation>
    </message>
    <message>
        <source>name each column once</source>
        <translation>nennen Sie jede Spalte einmal</translation>
    </message>
    <message>
        <source>has %1 cells where the first row has %2</source>
        <translation>hat %1 Zellen, die erste Zeile hat %2</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>ist leer</translation>
    </message>
    <message>
        <source>begin with a row of column names</source>
        <translation>beginnen Sie mit einer Zeile der Spaltennamen</translation>
    </message>
    <message>
        <source>its cells are separated by semicolons or tabs</source>
        <translation>die Zellen sind durch Semikolons oder Tabulatoren getrennt</translation>
    </message>
    <message>
        <source>save it with commas between the cells</source>
        <translation>speichern Sie die Datei mit Kommas zwischen den Zellen</translation>
    </message>
    <message>
        <source>has no column %1</source>
        <translation>hat keine Spalte %1</translation>
    </message>
    <message>
        <source>add it to the first row</source>
        <translation>fügen Sie sie der ersten Zeile hinzu</translation>
    </message>
    <message>
        <source>login %1 has another name here than in %2</source>
        <translation>der Anmeldename %1 hat hier einen anderen Namen als in %2</translation>
    </message>
    <message>
        <source>give every person a login of their own</source>
        <translation>geben Sie jeder Person einen eigenen Anmeldenamen</translation>
    </message>
    <message>
        <source>has no users.csv</source>
        <translation>enthält keine users.csv</translation>
    </message>
    <message>
        <source>give every row an id of its own</source>
        <translation>geben Sie jeder Zeile eine eigene Kennung</translation>
    </message>
    <message>
        <source>the SQLite driver of Qt is missing</source>
        <translation>der SQLite-Treiber von Qt fehlt</translation>
    </message>
    <message>
        <source>install libqt5sql5-sqlite (and start within a Qt application)</source>
        <translation>installieren Sie libqt5sql5-sqlite (und starten Sie in einer Qt-Anwendung)</translation>
    </message>
    <message>
        <source>%1: another program is writing to the store</source>
        <translation>%1: Ein anderes Programm schreibt gerade in den Datenbestand</translation>
    </message>
    <message>
        <source>wait for it or close it, then try again; nothing was lost</source>
        <translation>warten Sie, bis es fertig ist, oder schließen Sie es, und versuchen Sie es noch einmal; verloren ist nichts</translation>
    </message>
    <message>
        <source>%1: the store cannot be written</source>
        <translation>%1: In den Datenbestand kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>make the file and its folder writable for this user, or open it read-only</source>
        <translation>machen Sie die Datei und ihren Ordner für dieses Benutzerkonto beschreibbar, oder öffnen Sie sie nur zum Lesen</translation>
    </message>
    <message>
        <source>%1: the store cannot be opened (%2)</source>
        <translation>%1: Der Datenbestand kann nicht geöffnet werden (%2)</translation>
    </message>
    <message>
        <source>check that the path is right and that this user may read and write the file and its folder</source>
        <translation>prüfen Sie, ob der Pfad stimmt und ob dieses Benutzerkonto die Datei und ihren Ordner lesen und beschreiben darf</translation>
    </message>
    <message>
        <source>%1: not a Fulcrum store</source>
        <translation>%1: ist kein Datenbestand von Fulcrum</translation>
    </message>
    <message>
        <source>name the right file with --db</source>
        <translation>nennen Sie die richtige Datei mit --db</translation>
    </message>
    <message>
        <source>%1: the store is damaged (%2)</source>
        <translation>%1: Der Datenbestand ist beschädigt (%2)</translation>
    </message>
    <message>
        <source>run `fulcrum db check`, copy the file away, and restore the newest backup</source>
        <translation>führen Sie `fulcrum db check` aus, kopieren Sie die Datei an einen anderen Ort, und stellen Sie die neueste Sicherung wieder her</translation>
    </message>
    <message>
        <source>%1: no room left on the disk</source>
        <translation>%1: Auf dem Datenträger ist kein Platz mehr</translation>
    </message>
    <message>
        <source>free some space and try again; what was stored before is intact</source>
        <translation>schaffen Sie Platz, und versuchen Sie es noch einmal; was vorher gespeichert war, ist unversehrt</translation>
    </message>
    <message>
        <source>check the disk&apos;s space and health and try again; what was stored before is intact</source>
        <translation>prüfen Sie Platz und Zustand des Datenträgers, und versuchen Sie es noch einmal; was vorher gespeichert war, ist unversehrt</translation>
    </message>
    <message>
        <source>%1: refused by a rule of the store (%2)</source>
        <translation>%1: Eine Regel des Datenbestands lehnt das ab (%2)</translation>
    </message>
    <message>
        <source>correct the value and try again</source>
        <translation>berichtigen Sie den Wert, und versuchen Sie es noch einmal</translation>
    </message>
    <message>
        <source>run `fulcrum db check`</source>
        <translation>führen Sie `fulcrum db check` aus</translation>
    </message>
    <message>
        <source>a number that is not finite cannot be stored</source>
        <translation>eine Zahl, die nicht endlich ist, kann nicht gespeichert werden</translation>
    </message>
    <message>
        <source>leave it out, with the reason</source>
        <translation>lassen Sie sie weg, mit dem Grund</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; is unknown; known are %3</source>
        <translation>%1: „%2“ ist unbekannt; bekannt sind %3</translation>
    </message>
    <message>
        <source>use the program version that wrote the store, or restore the newest backup</source>
        <translation>verwenden Sie die Version der Software, die den Datenbestand geschrieben hat, oder stellen Sie die neueste Sicherung wieder her</translation>
    </message>
    <message>
        <source>not allowed: %1 as %2%3; act in a role that may, or ask someone who holds it</source>
        <translation>nicht erlaubt: %1 als %2%3; handeln Sie in einer Rolle, die es darf, oder fragen Sie jemanden, der sie hat</translation>
    </message>
    <message>
        <source>the text is not a JSON object</source>
        <translation>der Text ist kein JSON-Objekt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a hand</source>
        <translation>„%1“ ist keine Hand</translation>
    </message>
    <message>
        <source>a value of the %1 hand is out of range</source>
        <translation>ein Wert für die Hand „%1“ liegt außerhalb des erlaubten Bereichs</translation>
    </message>
    <message>
        <source>a stored state is damaged: %1</source>
        <translation>ein gespeicherter Zustand ist beschädigt: %1</translation>
    </message>
    <message>
        <source>close other programs: memory may be short</source>
        <translation>schließen Sie andere Programme: Der Arbeitsspeicher ist vielleicht knapp</translation>
    </message>
    <message>
        <source>it does not say its size</source>
        <translation>er nennt seine Größe nicht</translation>
    </message>
    <message>
        <source>it ends too early</source>
        <translation>es endet zu früh</translation>
    </message>
    <message>
        <source>the rest of the attempt can be read; restore the newest backup for this part</source>
        <translation>der Rest des Versuchs ist lesbar; stellen Sie für diesen Teil die neueste Sicherung wieder her</translation>
    </message>
    <message>
        <source>its layout</source>
        <translation>sein Aufbau</translation>
    </message>
    <message>
        <source>the inputs that it was made with are missing</source>
        <translation>die Eingaben, aus denen er entstand, fehlen</translation>
    </message>
    <message>
        <source>its ticks</source>
        <translation>seine Zeitpunkte</translation>
    </message>
    <message>
        <source>split it</source>
        <translation>teilen Sie ihn auf</translation>
    </message>
    <message>
        <source>free some memory</source>
        <translation>geben Sie Arbeitsspeicher frei</translation>
    </message>
    <message>
        <source>another stream</source>
        <translation>ein anderer Datenstrom</translation>
    </message>
    <message>
        <source>its size</source>
        <translation>seine Größe</translation>
    </message>
    <message>
        <source>its checksum</source>
        <translation>seine Prüfsumme</translation>
    </message>
    <message>
        <source>its length</source>
        <translation>seine Länge</translation>
    </message>
    <message>
        <source>its compression</source>
        <translation>seine Komprimierung</translation>
    </message>
    <message>
        <source>its header</source>
        <translation>sein Kopf</translation>
    </message>
    <message>
        <source>something follows its end</source>
        <translation>nach seinem Ende folgt noch etwas</translation>
    </message>
    <message>
        <source>a value out of range</source>
        <translation>ein Wert außerhalb des erlaubten Bereichs</translation>
    </message>
    <message>
        <source>install it again</source>
        <translation>installieren Sie sie neu</translation>
    </message>
    <message>
        <source>%1: rows of table %2 point nowhere after schema step %3</source>
        <translation>%1: Zeilen der Tabelle %2 verweisen nach Schemaschritt %3 ins Leere</translation>
    </message>
    <message>
        <source>the store was left as it was; restore a backup or report this</source>
        <translation>der Datenbestand blieb, wie er war; stellen Sie eine Sicherung wieder her, oder melden Sie das</translation>
    </message>
    <message>
        <source>is &quot;%1&quot;, but task %2 lists it as &quot;%3&quot;</source>
        <translation>ist „%1“, aber die Aufgabe %2 führt sie als „%3“ auf</translation>
    </message>
    <message>
        <source>write the same id in both files</source>
        <translation>schreiben Sie in beiden Dateien dieselbe Kennung</translation>
    </message>
    <message>
        <source>holds the set %1, not %2</source>
        <translation>enthält den Satz %1, nicht %2</translation>
    </message>
    <message>
        <source>name the file after its task, variant, device class and fidelity</source>
        <translation>benennen Sie die Datei nach Aufgabe, Variante, Geräteklasse und Genauigkeit</translation>
    </message>
    <message>
        <source>%1: this file can be used in assessed attempts already</source>
        <translation>%1: Diese Datei ist für bewertete Versuche schon zugelassen</translation>
    </message>
    <message>
        <source>practice only: these files are neither part of this program nor accepted by the programme: %1; an educator accepts a file with `fulcrum assets accept FILE --reason TEXT`</source>
        <translation>nur Übung: Diese Dateien gehören weder zu dieser Software, noch sind sie vom Programm zugelassen: %1; ein Ausbilder lässt eine Datei mit `fulcrum assets accept DATEI --reason TEXT` zu</translation>
    </message>
    <message>
        <source>a score is passed, failed, or not scored with a reason</source>
        <translation>eine Bewertung lautet bestanden, nicht bestanden oder nicht bewertet mit einem Grund</translation>
    </message>
    <message>
        <source>give one of them</source>
        <translation>geben Sie eines davon an</translation>
    </message>
    <message>
        <source>%1: the key of this station: %2</source>
        <translation>%1: der Schlüssel dieses Arbeitsplatzes: %2</translation>
    </message>
    <message>
        <source>make its folder readable and writable for you, or name another folder in FULCRUM_STATION_KEYS</source>
        <translation>machen Sie seinen Ordner für sich lesbar und beschreibbar, oder nennen Sie in FULCRUM_STATION_KEYS einen anderen Ordner</translation>
    </message>
    <message>
        <source>%1: is not a key of a station</source>
        <translation>%1: ist kein Schlüssel eines Arbeitsplatzes</translation>
    </message>
    <message>
        <source>put its copy back; without one move the file away, and a new key is made</source>
        <translation>legen Sie seine Kopie zurück; gibt es keine, verschieben Sie die Datei, und ein neuer Schlüssel wird angelegt</translation>
    </message>
    <message>
        <source>cannot be written (its folder cannot be made)</source>
        <translation>kann nicht geschrieben werden (sein Ordner lässt sich nicht anlegen)</translation>
    </message>
    <message>
        <source>was removed while it was being made</source>
        <translation>wurde entfernt, während er angelegt wurde</translation>
    </message>
    <message>
        <source>%1: written by a newer program (schema %2, this program knows %3)</source>
        <translation>%1: von einer neueren Software geschrieben (Schema %2, diese Software kennt %3)</translation>
    </message>
    <message>
        <source>update Fulcrum; nothing was changed</source>
        <translation>aktualisieren Sie Fulcrum; geändert wurde nichts</translation>
    </message>
    <message>
        <source>open it once for writing (`fulcrum db migrate`)</source>
        <translation>öffnen Sie ihn einmal zum Schreiben (`fulcrum db migrate`)</translation>
    </message>
    <message>
        <source>%1: the store does not name its station</source>
        <translation>%1: Der Datenbestand nennt seinen Arbeitsplatz nicht</translation>
    </message>
    <message>
        <source>run `fulcrum db check`, or restore the newest backup</source>
        <translation>führen Sie `fulcrum db check` aus, oder stellen Sie die neueste Sicherung wieder her</translation>
    </message>
    <message>
        <source>demo stores only</source>
        <translation>nur in der Vorführung</translation>
    </message>
    <message>
        <source>signed in to another store</source>
        <translation>bei einem anderen Datenbestand angemeldet</translation>
    </message>
    <message>
        <source>the account is no longer active</source>
        <translation>das Konto ist nicht mehr aktiv</translation>
    </message>
    <message>
        <source>the role was withdrawn</source>
        <translation>die Rolle wurde entzogen</translation>
    </message>
    <message>
        <source>the one-time password must be changed first</source>
        <translation>zuerst muss das Einmalpasswort geändert werden</translation>
    </message>
    <message>
        <source>not in this role</source>
        <translation>diese Rolle umfasst das nicht</translation>
    </message>
    <message>
        <source>outside this role&apos;s people</source>
        <translation>die Person ist dieser Rolle nicht zugeordnet</translation>
    </message>
    <message>
        <source>not allowed on one&apos;s own attempt</source>
        <translation>beim eigenen Versuch nicht erlaubt</translation>
    </message>
    <message>
        <source>%1: a file is already there</source>
        <translation>%1: Dort gibt es schon eine Datei</translation>
    </message>
    <message>
        <source>free some space and try again</source>
        <translation>schaffen Sie Platz, und versuchen Sie es noch einmal</translation>
    </message>
    <message>
        <source>choose a folder that this user can write</source>
        <translation>wählen Sie einen Ordner, den dieses Benutzerkonto beschreiben darf</translation>
    </message>
    <message>
        <source>make the file writable (chmod u+w), or open it read-only</source>
        <translation>machen Sie die Datei beschreibbar (chmod u+w), oder öffnen Sie sie nur zum Lesen</translation>
    </message>
    <message>
        <source>%1: an unfinished store, nothing was entered in it yet</source>
        <translation>%1: ein unfertiger Datenbestand, in den noch nichts eingetragen wurde</translation>
    </message>
    <message>
        <source>%1: the new store could not be completed</source>
        <translation>%1: Der neue Datenbestand konnte nicht fertiggestellt werden</translation>
    </message>
    <message>
        <source>check the disk&apos;s space and health and try again</source>
        <translation>prüfen Sie Platz und Zustand des Datenträgers, und versuchen Sie es noch einmal</translation>
    </message>
    <message>
        <source>%1: a program has the store open, or writes to it</source>
        <translation>%1: Ein Programm hat den Datenbestand geöffnet oder schreibt hinein</translation>
    </message>
    <message>
        <source>name the right file with --db, or move this one away first</source>
        <translation>nennen Sie die richtige Datei mit --db, oder verschieben Sie diese zuerst</translation>
    </message>
    <message>
        <source>use another backup; nothing was changed (`fulcrum db check --db FILE` lists all)</source>
        <translation>verwenden Sie eine andere Sicherung; geändert wurde nichts (`fulcrum db check --db DATEI` führt alles auf)</translation>
    </message>
    <message>
        <source>%1: the copy could not be completed</source>
        <translation>%1: Die Kopie konnte nicht fertiggestellt werden</translation>
    </message>
    <message>
        <source>check the disk&apos;s space and health and try again; nothing was changed</source>
        <translation>prüfen Sie Platz und Zustand des Datenträgers, und versuchen Sie es noch einmal; geändert wurde nichts</translation>
    </message>
    <message>
        <source>%1: this is the store itself</source>
        <translation>%1: Das ist der Datenbestand selbst</translation>
    </message>
    <message>
        <source>name the backup, and the store with --db</source>
        <translation>nennen Sie die Sicherung, und den Datenbestand mit --db</translation>
    </message>
    <message>
        <source>put the store back next to it, or move the log away, then try again</source>
        <translation>legen Sie den Datenbestand wieder daneben, oder verschieben Sie das Protokoll, und versuchen Sie es noch einmal</translation>
    </message>
    <message>
        <source>%1: the store is damaged</source>
        <translation>%1: Der Datenbestand ist beschädigt</translation>
    </message>
    <message>
        <source>restore the newest backup (`fulcrum db restore`)</source>
        <translation>stellen Sie die neueste Sicherung wieder her (`fulcrum db restore`)</translation>
    </message>
    <message>
        <source>%1: the PDF cannot be written</source>
        <translation>%1: Das PDF kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>choose another folder or free some space</source>
        <translation>wählen Sie einen anderen Ordner, oder schaffen Sie Platz</translation>
    </message>
    <message>
        <source>%1: this file is the store itself</source>
        <translation>%1: Diese Datei ist der Datenbestand selbst</translation>
    </message>
    <message>
        <source>choose another name for the report</source>
        <translation>wählen Sie einen anderen Namen für den Bericht</translation>
    </message>
    <message>
        <source>%1: the report cannot be written (%2)</source>
        <translation>%1: Der Bericht kann nicht geschrieben werden (%2)</translation>
    </message>
    <message>
        <source>unknown report format &quot;%1&quot;</source>
        <translation>unbekanntes Berichtsformat „%1“</translation>
    </message>
    <message>
        <source>one attempt has no report in the format %1</source>
        <translation>für einen einzelnen Versuch gibt es keinen Bericht im Format %1</translation>
    </message>
    <message>
        <source>use pdf, csv or json, or name a person or a cohort</source>
        <translation>verwenden Sie pdf, csv oder json, oder nennen Sie eine Person oder eine Gruppe</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a web address</source>
        <translation>„%1“ ist keine Webadresse</translation>
    </message>
    <message>
        <source>name the address that the ids of your people belong to, such as https://training.example</source>
        <translation>nennen Sie die Adresse, zu der die Kennungen Ihrer Personen gehören, zum Beispiel https://training.example</translation>
    </message>
    <message>
        <source>the workbook cannot be made (%1)</source>
        <translation>die Arbeitsmappe kann nicht erstellt werden (%1)</translation>
    </message>
    <message>
        <source>free some space in the folder of temporary files, or choose CSV</source>
        <translation>schaffen Sie Platz im Ordner für temporäre Dateien, oder wählen Sie CSV</translation>
    </message>
    <message>
        <source>no OpenGL context can be made: run it on a display, or under xvfb-run</source>
        <translation>es lässt sich kein OpenGL-Kontext anlegen: Starten Sie mit einem Bildschirm oder unter xvfb-run</translation>
    </message>
    <message>
        <source>no offscreen OpenGL surface can be made: run it on a display, or under xvfb-run</source>
        <translation>es lässt sich keine OpenGL-Fläche anlegen: Starten Sie mit einem Bildschirm oder unter xvfb-run</translation>
    </message>
    <message>
        <source>the renderer cannot start: %1</source>
        <translation>die Bilddarstellung kann nicht starten: %1</translation>
    </message>
    <message>
        <source>two mice</source>
        <translation>zwei Mäuse</translation>
    </message>
    <message>
        <source>cannot be read: there is no X server with XInput 2.1</source>
        <translation>können nicht gelesen werden: Es gibt keinen X-Server mit XInput 2.1</translation>
    </message>
    <message>
        <source>start Fulcrum in an X11 session, or use mouse and keyboard</source>
        <translation>starten Sie Fulcrum in einer X11-Sitzung, oder verwenden Sie Maus und Tastatur</translation>
    </message>
    <message>
        <source>connect a second mouse, or use mouse and keyboard</source>
        <translation>schließen Sie eine zweite Maus an, oder verwenden Sie Maus und Tastatur</translation>
    </message>
    <message>
        <source>see fulcrum %1 --help</source>
        <translation>siehe fulcrum %1 --help</translation>
    </message>
    <message>
        <source>unknown option of fulcrum %1</source>
        <translation>unbekannte Option von fulcrum %1</translation>
    </message>
    <message>
        <source>did you mean %1? %2</source>
        <translation>meinten Sie %1? %2</translation>
    </message>
    <message>
        <source>too few arguments</source>
        <translation>zu wenige Argumente</translation>
    </message>
    <message>
        <source>usage: %1</source>
        <translation>Aufruf: %1</translation>
    </message>
    <message>
        <source>unexpected argument</source>
        <translation>unerwartetes Argument</translation>
    </message>
    <message>
        <source>an argument is empty</source>
        <translation>ein Argument ist leer</translation>
    </message>
    <message>
        <source>given twice</source>
        <translation>doppelt angegeben</translation>
    </message>
    <message>
        <source>give it once</source>
        <translation>geben Sie es einmal an</translation>
    </message>
    <message>
        <source>takes no argument</source>
        <translation>nimmt kein Argument</translation>
    </message>
    <message>
        <source>leave &apos;=%1&apos; out</source>
        <translation>lassen Sie &apos;=%1&apos; weg</translation>
    </message>
    <message>
        <source>write %1 %2; %3</source>
        <translation>schreiben Sie %1 %2; %3</translation>
    </message>
    <message>
        <source>its argument is missing</source>
        <translation>das Argument fehlt</translation>
    </message>
    <message>
        <source>its argument is empty</source>
        <translation>das Argument ist leer</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a known %2</source>
        <translation>„%1“ ist kein bekanntes %2</translation>
    </message>
    <message>
        <source>did you mean %1? Use one of %2</source>
        <translation>meinten Sie %1? Verwenden Sie eines von %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a whole number in the range</source>
        <translation>„%1“ ist keine ganze Zahl im erlaubten Bereich</translation>
    </message>
    <message>
        <source>give a number from %1 to %2</source>
        <translation>geben Sie eine Zahl von %1 bis %2 an</translation>
    </message>
    <message>
        <source>cannot write to %1</source>
        <translation>%1 kann nicht beschrieben werden</translation>
    </message>
    <message>
        <source>name a writable folder</source>
        <translation>nennen Sie einen beschreibbaren Ordner</translation>
    </message>
    <message>
        <source>cannot be combined with %1</source>
        <translation>lässt sich nicht mit %1 verbinden</translation>
    </message>
    <message>
        <source>use only one of them</source>
        <translation>verwenden Sie nur eines davon</translation>
    </message>
    <message>
        <source>argument %1</source>
        <translation>Argument %1</translation>
    </message>
    <message>
        <source>is not valid UTF-8</source>
        <translation>ist kein gültiges UTF-8</translation>
    </message>
    <message>
        <source>write it, and names of files, in UTF-8</source>
        <translation>schreiben Sie es, und Dateinamen, in UTF-8</translation>
    </message>
    <message>
        <source>needs the program &apos;%1&apos;, which is missing</source>
        <translation>braucht das Programm „%1“, das fehlt</translation>
    </message>
    <message>
        <source>build the laboratory: ./run laboratory</source>
        <translation>bauen Sie das Labor: ./run laboratory</translation>
    </message>
    <message>
        <source>the action is missing</source>
        <translation>die Aktion fehlt</translation>
    </message>
    <message>
        <source>unknown action</source>
        <translation>unbekannte Aktion</translation>
    </message>
    <message>
        <source>unknown option</source>
        <translation>unbekannte Option</translation>
    </message>
    <message>
        <source>unknown command</source>
        <translation>unbekannter Befehl</translation>
    </message>
    <message>
        <source>no person &apos;%1&apos;</source>
        <translation>es gibt keine Person „%1“</translation>
    </message>
    <message>
        <source>name logins of this store, separated by commas</source>
        <translation>nennen Sie Anmeldenamen dieses Datenbestands, durch Kommas getrennt</translation>
    </message>
    <message>
        <source>is %1, whose attempts are compared with the sets of %2</source>
        <translation>ist %1; Versuche damit werden mit den Sätzen von %2 verglichen</translation>
    </message>
    <message>
        <source>name %1, or remove its family from the task</source>
        <translation>nennen Sie %1, oder entfernen Sie die Familie aus der Aufgabe</translation>
    </message>
    <message>
        <source>give logins separated by commas</source>
        <translation>geben Sie Anmeldenamen an, durch Kommas getrennt</translation>
    </message>
    <message>
        <source>needs either --operators or --experts</source>
        <translation>braucht entweder --operators oder --experts</translation>
    </message>
    <message>
        <source>--all builds the sets of all tasks</source>
        <translation>--all erstellt die Sätze aller Aufgaben</translation>
    </message>
    <message>
        <source>remove one of them</source>
        <translation>entfernen Sie eines davon</translation>
    </message>
    <message>
        <source>names no task</source>
        <translation>nennt keine Aufgabe</translation>
    </message>
    <message>
        <source>give a task, or --all</source>
        <translation>geben Sie eine Aufgabe an, oder --all</translation>
    </message>
    <message>
        <source>needs exactly one of --person and --cohort</source>
        <translation>braucht genau eines von --person und --cohort</translation>
    </message>
    <message>
        <source>no cohort &apos;%1&apos; that you may read</source>
        <translation>es gibt keine Gruppe „%1“, die Sie lesen dürfen</translation>
    </message>
    <message>
        <source>name a cohort of this store</source>
        <translation>nennen Sie eine Gruppe dieses Datenbestands</translation>
    </message>
    <message>
        <source>say why, or look first with --dry-run</source>
        <translation>nennen Sie den Grund, oder sehen Sie es sich zuerst mit --dry-run an</translation>
    </message>
    <message>
        <source>give a CSV file with a header row</source>
        <translation>geben Sie eine CSV-Datei mit einer Kopfzeile an</translation>
    </message>
    <message>
        <source>write a finite number</source>
        <translation>schreiben Sie eine endliche Zahl</translation>
    </message>
    <message>
        <source>see fulcrum curriculum rule --help</source>
        <translation>siehe fulcrum curriculum rule --help</translation>
    </message>
    <message>
        <source>is not %1</source>
        <translation>ist nicht %1</translation>
    </message>
    <message>
        <source>number the attempts 1, 2, 3, ... in order</source>
        <translation>nummerieren Sie die Versuche der Reihe nach 1, 2, 3, ...</translation>
    </message>
    <message>
        <source>%1 attempts are too few for a curve</source>
        <translation>%1 Versuche sind zu wenige für eine Kurve</translation>
    </message>
    <message>
        <source>give at least %1</source>
        <translation>geben Sie mindestens %1 an</translation>
    </message>
    <message>
        <source>%1 has rated %2 twice</source>
        <translation>%1 hat %2 doppelt beurteilt</translation>
    </message>
    <message>
        <source>give one score for each target and rater</source>
        <translation>geben Sie eine Bewertung je Ziel und Beurteiler an</translation>
    </message>
    <message>
        <source>there is no score of %1 by %2</source>
        <translation>es gibt keine Bewertung von %1 durch %2</translation>
    </message>
    <message>
        <source>every rater must have rated every target</source>
        <translation>jeder Beurteiler muss jedes Ziel beurteilt haben</translation>
    </message>
    <message>
        <source>give scores of two or more raters on two or more targets</source>
        <translation>geben Sie Bewertungen von mindestens zwei Beurteilern zu mindestens zwei Zielen an</translation>
    </message>
    <message>
        <source>has no logarithm</source>
        <translation>hat keinen Logarithmus</translation>
    </message>
    <message>
        <source>give values above 0, or --scale raw</source>
        <translation>geben Sie Werte über 0 an, oder --scale raw</translation>
    </message>
    <message>
        <source>fewer than 2 experts are left</source>
        <translation>es bleiben weniger als 2 Experten</translation>
    </message>
    <message>
        <source>give the values of more experts</source>
        <translation>geben Sie die Werte von mehr Experten an</translation>
    </message>
    <message>
        <source>standard input</source>
        <translation>Standardeingabe</translation>
    </message>
    <message>
        <source>is larger than 1 GiB</source>
        <translation>ist größer als 1 GiB</translation>
    </message>
    <message>
        <source>give a smaller input</source>
        <translation>geben Sie eine kleinere Eingabe an</translation>
    </message>
    <message>
        <source>needs the task that was performed</source>
        <translation>braucht die Aufgabe, die durchgeführt wurde</translation>
    </message>
    <message>
        <source>name it: --task TASK</source>
        <translation>nennen Sie sie: --task AUFGABE</translation>
    </message>
    <message>
        <source>cannot be used with --events</source>
        <translation>lässt sich nicht mit --events verwenden</translation>
    </message>
    <message>
        <source>a verdict needs a trace in the documented format</source>
        <translation>ein Ergebnis braucht eine Aufzeichnung im dokumentierten Format</translation>
    </message>
    <message>
        <source>has no meaning without --events</source>
        <translation>hat ohne --events keine Bedeutung</translation>
    </message>
    <message>
        <source>name the events: --events EVENTS.csv</source>
        <translation>nennen Sie die Ereignisse: --events EVENTS.csv</translation>
    </message>
    <message>
        <source>is not a JSON object</source>
        <translation>ist kein JSON-Objekt</translation>
    </message>
    <message>
        <source>give a scene, task or benchmark file</source>
        <translation>geben Sie eine Szenen-, Aufgaben- oder Richtwertdatei an</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not the head of an audit log</source>
        <translation>„%1“ ist nicht der Kopf eines Protokolls</translation>
    </message>
    <message>
        <source>give its first 16 to 64 hexadecimal digits, as reports and `db audit` print them</source>
        <translation>geben Sie seine ersten 16 bis 64 Hexadezimalziffern an, wie Berichte und `db audit` sie nennen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not the fingerprint of a station&apos;s key</source>
        <translation>„%1“ ist nicht der Fingerabdruck eines Arbeitsplatzschlüssels</translation>
    </message>
    <message>
        <source>give its first 16 to 32 hexadecimal digits, as reports and `db audit` print them</source>
        <translation>geben Sie seine ersten 16 bis 32 Hexadezimalziffern an, wie Berichte und `db audit` sie nennen</translation>
    </message>
    <message>
        <source>is missing; only an administrator of the backup restores it</source>
        <translation>fehlt; nur ein Administrator der Sicherung stellt sie wieder her</translation>
    </message>
    <message>
        <source>sign in with --as LOGIN, and --password-file FILE where there is no terminal</source>
        <translation>melden Sie sich mit --as ANMELDENAME an, und mit --password-file DATEI, wo es kein Terminal gibt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a time</source>
        <translation>„%1“ ist keine Zeit</translation>
    </message>
    <message>
        <source>give a day (2026-11-21) or a time (2026-11-21T04:07:37Z), UTC</source>
        <translation>geben Sie einen Tag (2026-11-21) oder eine Zeit (2026-11-21T04:07:37Z) an, UTC</translation>
    </message>
    <message>
        <source>no entry of kind &apos;%1&apos;</source>
        <translation>es gibt keinen Eintrag der Art „%1“</translation>
    </message>
    <message>
        <source>name one of %1, or the part before a dot</source>
        <translation>nennen Sie eine von %1, oder den Teil vor einem Punkt</translation>
    </message>
    <message>
        <source>is not after --from</source>
        <translation>liegt nicht nach --from</translation>
    </message>
    <message>
        <source>give a later time</source>
        <translation>geben Sie eine spätere Zeit an</translation>
    </message>
    <message>
        <source>the numbers of inputs and samples differ</source>
        <translation>Eingaben und Messwerte sind nicht gleich viele</translation>
    </message>
    <message>
        <source>run fulcrum db check</source>
        <translation>führen Sie fulcrum db check aus</translation>
    </message>
    <message>
        <source>began with a state that &quot;%1&quot; wrote and this build (&quot;%2&quot;) cannot read</source>
        <translation>begann mit einem Zustand, den „%1“ schrieb und diese Version („%2“) nicht lesen kann</translation>
    </message>
    <message>
        <source>replay it with that version of the program</source>
        <translation>geben Sie ihn mit jener Version der Software wieder</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a value</source>
        <translation>„%1“ ist kein Wert</translation>
    </message>
    <message>
        <source>write TISSUE.KEY=NUMBER, for example areolar.penetrate_n=0.12</source>
        <translation>schreiben Sie TISSUE.KEY=NUMBER, zum Beispiel areolar.penetrate_n=0.12</translation>
    </message>
    <message>
        <source>there is no change to give a reason for</source>
        <translation>es gibt keine Änderung, die einen Grund braucht</translation>
    </message>
    <message>
        <source>add --set or --scene-values</source>
        <translation>fügen Sie --set oder --scene-values hinzu</translation>
    </message>
    <message>
        <source>has no meaning without --as</source>
        <translation>hat ohne --as keine Bedeutung</translation>
    </message>
    <message>
        <source>name the person who signs in: --as LOGIN</source>
        <translation>nennen Sie die Person, die sich anmeldet: --as ANMELDENAME</translation>
    </message>
    <message>
        <source>is missing; this command reads personal data</source>
        <translation>fehlt; dieser Befehl liest personenbezogene Daten</translation>
    </message>
    <message>
        <source>no person &apos;%1&apos; that you may read</source>
        <translation>es gibt keine Person „%1“, die Sie lesen dürfen</translation>
    </message>
    <message>
        <source>name a login of this store</source>
        <translation>nennen Sie einen Anmeldenamen dieses Datenbestands</translation>
    </message>
    <message>
        <source>see fulcrum --help</source>
        <translation>siehe fulcrum --help</translation>
    </message>
    <message>
        <source>did you mean %1? see fulcrum --help</source>
        <translation>meinten Sie %1? siehe fulcrum --help</translation>
    </message>
    <message>
        <source>no completion for this shell</source>
        <translation>für diese Shell gibt es keine Vervollständigung</translation>
    </message>
    <message>
        <source>use bash or zsh</source>
        <translation>verwenden Sie bash oder zsh</translation>
    </message>
    <message>
        <source>there is no terminal to ask for a password</source>
        <translation>es gibt kein Terminal, um nach einem Passwort zu fragen</translation>
    </message>
    <message>
        <source>give --password-file FILE</source>
        <translation>geben Sie --password-file DATEI an</translation>
    </message>
    <message>
        <source>no password was entered</source>
        <translation>es wurde kein Passwort eingegeben</translation>
    </message>
    <message>
        <source>type it and press Enter</source>
        <translation>geben Sie es ein, und drücken Sie die Eingabetaste</translation>
    </message>
    <message>
        <source>give a file with the password on its first line</source>
        <translation>geben Sie eine Datei an, in deren erster Zeile das Passwort steht</translation>
    </message>
    <message>
        <source>its first line is empty</source>
        <translation>die erste Zeile ist leer</translation>
    </message>
    <message>
        <source>is not the file that attempt %1 began with (sha256 %2)</source>
        <translation>ist nicht die Datei, mit der der Versuch %1 begann (sha256 %2)</translation>
    </message>
    <message>
        <source>restore that file, then start the program again</source>
        <translation>stellen Sie jene Datei wieder her, und starten Sie die Software neu</translation>
    </message>
    <message>
        <source>The left hand&apos;s device</source>
        <translation>Das Gerät der linken Hand</translation>
    </message>
    <message>
        <source>The right hand&apos;s device</source>
        <translation>Das Gerät der rechten Hand</translation>
    </message>
    <message>
        <source>The scope&apos;s device</source>
        <translation>Das Gerät der Optik</translation>
    </message>
    <message>
        <source>the attempt had not begun; nothing was stored</source>
        <translation>der Versuch hatte noch nicht begonnen; gespeichert wurde nichts</translation>
    </message>
    <message>
        <source>the attempt could not be started: %1</source>
        <translation>der Versuch konnte nicht beginnen: %1</translation>
    </message>
    <message>
        <source>the attempt could not be stored completely: %1; the part that was stored is kept and listed as interrupted</source>
        <translation>der Versuch konnte nicht vollständig gespeichert werden: %1; der gespeicherte Teil bleibt und ist als unterbrochen aufgeführt</translation>
    </message>
    <message>
        <source>%1 gave an impossible reading (not a number, or a jump).</source>
        <translation>%1 lieferte einen unmöglichen Messwert (keine Zahl, oder ein Sprung).</translation>
    </message>
    <message>
        <source>%1 does not answer.</source>
        <translation>%1 antwortet nicht.</translation>
    </message>
    <message>
        <source>%1 The force was reduced to zero and the timer is stopped; the recording is kept. Reconnect the device: within one minute the attempt can resume as practice, after that it is closed as interrupted. An attempt that had already failed stays failed.</source>
        <translation>%1 Die Kraft wurde auf null gesenkt, und die Uhr steht; die Aufzeichnung bleibt. Schließen Sie das Gerät wieder an: Innerhalb einer Minute kann der Versuch als Übung weitergehen, danach wird er als unterbrochen abgeschlossen. Ein Versuch, der schon nicht bestanden war, bleibt es.</translation>
    </message>
    <message>
        <source>has fewer than two samples</source>
        <translation>hat weniger als zwei Messwerte</translation>
    </message>
    <message>
        <source>give a recorded trace</source>
        <translation>geben Sie eine aufgezeichnete Spur an</translation>
    </message>
    <message>
        <source>has no tip positions: columns left.px left.py left.pz (or right) are missing</source>
        <translation>hat keine Positionen der Spitze: Die Spalten left.px left.py left.pz (oder right) fehlen</translation>
    </message>
    <message>
        <source>add the tip positions of at least one hand</source>
        <translation>fügen Sie die Positionen der Spitze mindestens einer Hand hinzu</translation>
    </message>
    <message>
        <source>choose practice, or use another device</source>
        <translation>wählen Sie Übung, oder verwenden Sie ein anderes Gerät</translation>
    </message>
    <message>
        <source>perform it as practice until then</source>
        <translation>führen Sie ihn bis dahin als Übung durch</translation>
    </message>
    <message>
        <source>open the replay again</source>
        <translation>öffnen Sie die Wiedergabe noch einmal</translation>
    </message>
    <message>
        <source>has no goal %1</source>
        <translation>hat keinen Schritt %1</translation>
    </message>
    <message>
        <source>choose one of its goals</source>
        <translation>wählen Sie einen ihrer Schritte</translation>
    </message>
    <message>
        <source>name the stage: --stage A</source>
        <translation>nennen Sie die Stufe: --stage A</translation>
    </message>
    <message>
        <source>name the file to write: -o FILE</source>
        <translation>nennen Sie die Datei, die geschrieben werden soll: -o DATEI</translation>
    </message>
    <message>
        <source>this person has not completed the stage</source>
        <translation>diese Person hat die Stufe nicht abgeschlossen</translation>
    </message>
    <message>
        <source>a certificate needs proficiency in every task of the stage; provisional limits give none</source>
        <translation>für ein Zertifikat muss jede Aufgabe der Stufe sicher beherrscht sein; vorläufige Grenzwerte genügen nicht</translation>
    </message>
    <message>
        <source>needs exactly one of --verify and --person</source>
        <translation>braucht genau eines von --verify und --person</translation>
    </message>
    <message>
        <source>is not possible: this device renders no force</source>
        <translation>ist nicht möglich: Dieses Gerät gibt keine Kraft wieder</translation>
    </message>
    <message>
        <source>leave it out</source>
        <translation>lassen Sie es weg</translation>
    </message>
    <message>
        <source>has no meaning without --test</source>
        <translation>hat ohne --test keine Bedeutung</translation>
    </message>
    <message>
        <source>name a device: --test DEVICE</source>
        <translation>nennen Sie ein Gerät: --test GERÄT</translation>
    </message>
    <message>
        <source>standard output: not everything could be written; check the pipe or free some space</source>
        <translation>Standardausgabe: Nicht alles konnte geschrieben werden; prüfen Sie die Pipe, oder schaffen Sie Platz</translation>
    </message>
    <message>
        <source>JSON: %1; correct the document</source>
        <translation>JSON: %1; berichtigen Sie das Dokument</translation>
    </message>
    <message>
        <source>not enough memory; close other programs or give smaller input</source>
        <translation>nicht genug Arbeitsspeicher; schließen Sie andere Programme, oder geben Sie eine kleinere Eingabe an</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not the name of a language</source>
        <translation>„%1“ ist nicht der Name einer Sprache</translation>
    </message>
    <message>
        <source>use one of: %1</source>
        <translation>verwenden Sie eine von: %1</translation>
    </message>
    <message>
        <source>is for one attempt</source>
        <translation>ist für einen einzelnen Versuch</translation>
    </message>
    <message>
        <source>name it: --attempt ID</source>
        <translation>nennen Sie ihn: --attempt ID</translation>
    </message>
    <message>
        <source>needs exactly one of --person, --cohort and --attempt</source>
        <translation>braucht genau eines von --person, --cohort und --attempt</translation>
    </message>
    <message>
        <source>cannot be read, or is empty</source>
        <translation>kann nicht gelesen werden, oder ist leer</translation>
    </message>
    <message>
        <source>times must increase from 0</source>
        <translation>Zeiten müssen ab 0 steigen</translation>
    </message>
    <message>
        <source>a folder</source>
        <translation>ein Ordner</translation>
    </message>
    <message>
        <source>a pipe</source>
        <translation>eine Pipe</translation>
    </message>
    <message>
        <source>a socket</source>
        <translation>ein Socket</translation>
    </message>
    <message>
        <source>a device</source>
        <translation>ein Gerät</translation>
    </message>
    <message>
        <source>a tip cannot move by less than 0</source>
        <translation>eine Spitze kann sich nicht um weniger als 0 bewegen</translation>
    </message>
    <message>
        <source>a scene needs instruments or targets for the camera</source>
        <translation>eine Szene braucht Instrumente oder Ziele für die Kamera</translation>
    </message>
    <message>
        <source>give a number above %1, at most %2</source>
        <translation>geben Sie eine Zahl über %1 und höchstens %2 an</translation>
    </message>
    <message>
        <source>use numbers between -1e308 and 1e308</source>
        <translation>verwenden Sie Zahlen zwischen -1e308 und 1e308</translation>
    </message>
    <message>
        <source>left</source>
        <translation>linke</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechte</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 oder %2</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>eine Liste</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>einen Text</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>null</source>
        <translation>null</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1 above %2 to %3</source>
        <translation>%1 über %2 bis %3</translation>
    </message>
    <message>
        <source>%1 above %2</source>
        <translation>%1 über %2</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1 von %2 bis %3</translation>
    </message>
    <message>
        <source>%1 from %2</source>
        <translation>%1 ab %2</translation>
    </message>
    <message>
        <source>%1 up to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>one of: %1</source>
        <translation>eines von: %1</translation>
    </message>
    <message>
        <source>another value</source>
        <translation>einen anderen Wert</translation>
    </message>
    <message>
        <source>give %1</source>
        <translation>geben Sie %1 an</translation>
    </message>
    <message>
        <source>give %1 (%2)</source>
        <translation>geben Sie %1 an (%2)</translation>
    </message>
    <message>
        <source>the value has the wrong type</source>
        <translation>der Wert hat den falschen Typ</translation>
    </message>
    <message>
        <source>the number is too large</source>
        <translation>die Zahl ist zu groß</translation>
    </message>
    <message>
        <source>the number is too small</source>
        <translation>die Zahl ist zu klein</translation>
    </message>
    <message>
        <source>the value is not one of those allowed</source>
        <translation>der Wert ist keiner der erlaubten</translation>
    </message>
    <message>
        <source>the value is not the one allowed</source>
        <translation>der Wert ist nicht der erlaubte</translation>
    </message>
    <message>
        <source>the list is too long</source>
        <translation>die Liste ist zu lang</translation>
    </message>
    <message>
        <source>the list is too short</source>
        <translation>die Liste ist zu kurz</translation>
    </message>
    <message>
        <source>the text is too long</source>
        <translation>der Text ist zu lang</translation>
    </message>
    <message>
        <source>the text is too short</source>
        <translation>der Text ist zu kurz</translation>
    </message>
    <message>
        <source>the text has characters that are not allowed</source>
        <translation>der Text enthält Zeichen, die nicht erlaubt sind</translation>
    </message>
    <message>
        <source>the keys here are %1</source>
        <translation>die Schlüssel hier sind %1</translation>
    </message>
    <message>
        <source>unknown key &quot;%1&quot;</source>
        <translation>unbekannter Schlüssel &quot;%1&quot;</translation>
    </message>
    <message>
        <source>remove it; %1</source>
        <translation>entfernen Sie ihn; %1</translation>
    </message>
    <message>
        <source>did you mean &quot;%1&quot;? %2</source>
        <translation>meinten Sie &quot;%1&quot;? %2</translation>
    </message>
    <message>
        <source>the key &quot;%1&quot; is missing</source>
        <translation>der Schlüssel &quot;%1&quot; fehlt</translation>
    </message>
    <message>
        <source>give each hand one instrument</source>
        <translation>geben Sie jeder Hand ein Instrument</translation>
    </message>
    <message>
        <source>contains no folder &quot;tasks&quot;</source>
        <translation>enthält keinen Ordner &quot;tasks&quot;</translation>
    </message>
    <message>
        <source>the folder was not found next to the program or above it</source>
        <translation>der Ordner wurde weder neben der Software noch darüber gefunden</translation>
    </message>
    <message>
        <source>the expert did not reach this goal</source>
        <translation>der Experte hat diesen Schritt nicht erreicht</translation>
    </message>
    <message>
        <source>contains no curriculum %1</source>
        <translation>enthält kein Curriculum %1</translation>
    </message>
    <message>
        <source>the file %1 has the same version</source>
        <translation>die Datei %1 hat dieselbe Version</translation>
    </message>
    <message>
        <source>another form has the same id and version: %1</source>
        <translation>ein anderer Bogen hat dieselbe Kennung und Version: %1</translation>
    </message>
    <message>
        <source>degrees from the middle of the image</source>
        <translation>Grad von der Bildmitte</translation>
    </message>
    <message>
        <source>degrees between the image&apos;s upright and the body&apos;s</source>
        <translation>Grad zwischen der Senkrechten des Bildes und der des Körpers</translation>
    </message>
    <message>
        <source>how far the size may be off the wanted one</source>
        <translation>wie weit die Größe von der gewünschten abweichen darf</translation>
    </message>
    <message>
        <source>the least traction across the line, N/m</source>
        <translation>der kleinste Zug quer zur Linie, N/m</translation>
    </message>
    <message>
        <source>the most traction across the line, N/m</source>
        <translation>der größte Zug quer zur Linie, N/m</translation>
    </message>
    <message>
        <source>left or right</source>
        <translation>left oder right</translation>
    </message>
    <message>
        <source>how many spheres</source>
        <translation>wie viele Kugeln</translation>
    </message>
    <message>
        <source>seconds to hold each</source>
        <translation>Sekunden, die jede gehalten wird</translation>
    </message>
    <message>
        <source>metres of bowel to run</source>
        <translation>Meter Darm, die durchgemustert werden</translation>
    </message>
    <message>
        <source>where to start</source>
        <translation>wo es beginnt</translation>
    </message>
    <message>
        <source>where the run leads</source>
        <translation>wohin es führt</translation>
    </message>
    <message>
        <source>shortest step that counts</source>
        <translation>kürzester Griff, der zählt</translation>
    </message>
    <message>
        <source>longest step that counts</source>
        <translation>längster Griff, der zählt</translation>
    </message>
    <message>
        <source>seconds to hold</source>
        <translation>Sekunden, die gehalten wird</translation>
    </message>
    <message>
        <source>where the stretch begins</source>
        <translation>wo der Abschnitt beginnt</translation>
    </message>
    <message>
        <source>where the stretch ends</source>
        <translation>wo der Abschnitt endet</translation>
    </message>
    <message>
        <source>metres above the resting height</source>
        <translation>Meter über der Ruhehöhe</translation>
    </message>
    <message>
        <source>seconds to keep the traction</source>
        <translation>Sekunden, die der Zug gehalten wird</translation>
    </message>
    <message>
        <source>metres of the marked line</source>
        <translation>Meter der markierten Linie</translation>
    </message>
    <message>
        <source>metres from the line that are too far</source>
        <translation>Meter von der Linie, die zu weit sind</translation>
    </message>
    <message>
        <source>metres from the line within which a cut divides it</source>
        <translation>Meter von der Linie, innerhalb derer ein Schnitt sie durchtrennt</translation>
    </message>
    <message>
        <source>seconds without a hold</source>
        <translation>Sekunden ohne Halt</translation>
    </message>
    <message>
        <source>how many bands</source>
        <translation>wie viele Stränge</translation>
    </message>
    <message>
        <source>how many vessels</source>
        <translation>wie viele Gefäße</translation>
    </message>
    <message>
        <source>seconds without bleeding</source>
        <translation>Sekunden ohne Blutung</translation>
    </message>
    <message>
        <source>seconds of contact</source>
        <translation>Sekunden Kontakt</translation>
    </message>
    <message>
        <source>the hand that lifts each ring: left or right</source>
        <translation>die Hand, die jeden Ring hebt: left oder right</translation>
    </message>
    <message>
        <source>how many rings</source>
        <translation>wie viele Ringe</translation>
    </message>
    <message>
        <source>seconds that both hands hold a ring in the air</source>
        <translation>Sekunden, die beide Hände einen Ring in der Luft halten</translation>
    </message>
    <message>
        <source>metres above the tray from where on a ring is in the air</source>
        <translation>Meter über dem Tablett, ab denen ein Ring in der Luft ist</translation>
    </message>
    <message>
        <source>how many targets</source>
        <translation>wie viele Ziele</translation>
    </message>
    <message>
        <source>seconds to keep each framed</source>
        <translation>Sekunden, die jedes im Bild bleibt</translation>
    </message>
    <message>
        <source>seconds in all that the tip is framed</source>
        <translation>Sekunden insgesamt, die die Spitze im Bild ist</translation>
    </message>
    <message>
        <source>the target has a size within this share at every distance</source>
        <translation>bei jedem Abstand liegt die Größe des Ziels innerhalb dieses Anteils</translation>
    </message>
    <message>
        <source>write one sample per row</source>
        <translation>schreiben Sie einen Messwert je Zeile</translation>
    </message>
    <message>
        <source>names</source>
        <translation>Namen</translation>
    </message>
    <message>
        <source>units</source>
        <translation>Einheiten</translation>
    </message>
    <message>
        <source>give one attempt per file</source>
        <translation>geben Sie einen Versuch je Datei an</translation>
    </message>
    <message>
        <source>the time decreases</source>
        <translation>die Zeit nimmt ab</translation>
    </message>
    <message>
        <source>use one label per tissue</source>
        <translation>verwenden Sie einen Namen je Gewebe</translation>
    </message>
    <message>
        <source>the column occurs twice</source>
        <translation>die Spalte kommt doppelt vor</translation>
    </message>
    <message>
        <source>give every row one cell per column</source>
        <translation>geben Sie jeder Zeile eine Zelle je Spalte</translation>
    </message>
    <message>
        <source>the time does not increase</source>
        <translation>die Zeit nimmt nicht zu</translation>
    </message>
    <message>
        <source>sort the rows and remove duplicates</source>
        <translation>ordnen Sie die Zeilen, und entfernen Sie doppelte</translation>
    </message>
    <message>
        <source>write one row per sample</source>
        <translation>schreiben Sie eine Zeile je Messwert</translation>
    </message>
    <message>
        <source>trainee</source>
        <translation>Lernende(r)</translation>
    </message>
    <message>
        <source>educator</source>
        <translation>Ausbilder</translation>
    </message>
    <message>
        <source>director</source>
        <translation>Programmleitung</translation>
    </message>
    <message>
        <source>administrator</source>
        <translation>Administrator</translation>
    </message>
    <message>
        <source>station</source>
        <translation>Arbeitsplatz</translation>
    </message>
    <message>
        <source>a reason is missing or too long</source>
        <translation>der Grund fehlt oder ist zu lang</translation>
    </message>
    <message>
        <source>give a reason of 1 to 4,000 characters</source>
        <translation>geben Sie einen Grund von 1 bis 4000 Zeichen an</translation>
    </message>
    <message>
        <source>there is nothing left to do</source>
        <translation>es ist nichts mehr zu tun</translation>
    </message>
    <message>
        <source>the attempt belongs to that person already</source>
        <translation>der Versuch gehört dieser Person schon</translation>
    </message>
    <message>
        <source>the part before it is missing</source>
        <translation>der Teil davor fehlt</translation>
    </message>
    <message>
        <source>%1 is not a real person (%2) and cannot be in a cohort</source>
        <translation>%1 ist keine echte Person (%2) und kann in keiner Gruppe sein</translation>
    </message>
    <message>
        <source>choose real people only</source>
        <translation>wählen Sie nur echte Personen</translation>
    </message>
    <message>
        <source>%1: it contains control or direction characters</source>
        <translation>%1: enthält Steuer- oder Richtungszeichen</translation>
    </message>
    <message>
        <source>%1: it is empty or too long</source>
        <translation>%1: ist leer oder zu lang</translation>
    </message>
    <message>
        <source>choose another one</source>
        <translation>wählen Sie einen anderen</translation>
    </message>
    <message>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>the last administrator cannot be deactivated</source>
        <translation>der letzte Administrator kann nicht deaktiviert werden</translation>
    </message>
    <message>
        <source>synthetic and external people cannot have roles</source>
        <translation>synthetische und externe Personen können keine Rollen haben</translation>
    </message>
    <message>
        <source>the last administrator cannot give up the role</source>
        <translation>der letzte Administrator kann die Rolle nicht abgeben</translation>
    </message>
    <message>
        <source>only an administrator can make an account for a real person</source>
        <translation>nur ein Administrator kann ein Konto für eine echte Person anlegen</translation>
    </message>
    <message>
        <source>ask an administrator</source>
        <translation>fragen Sie einen Administrator</translation>
    </message>
    <message>
        <source>the form %1 of a rating is missing</source>
        <translation>der Bogen %1 einer Beurteilung fehlt</translation>
    </message>
    <message>
        <source>give one answer per item</source>
        <translation>geben Sie eine Antwort je Punkt</translation>
    </message>
    <message>
        <source>you have a form for this attempt that is not handed in yet</source>
        <translation>Sie haben für diesen Versuch einen Bogen, der noch nicht abgegeben ist</translation>
    </message>
    <message>
        <source>write another comment</source>
        <translation>schreiben Sie einen anderen Kommentar</translation>
    </message>
    <message>
        <source>use &quot;Change password&quot;</source>
        <translation>verwenden Sie „Passwort ändern“</translation>
    </message>
    <message>
        <source>a quotation mark opens here and is never closed</source>
        <translation>hier öffnet ein Anführungszeichen, das nicht geschlossen wird</translation>
    </message>
    <message>
        <source>close the cell with a quotation mark</source>
        <translation>schließen Sie die Zelle mit einem Anführungszeichen</translation>
    </message>
    <message>
        <source>split it into smaller files</source>
        <translation>teilen Sie sie in kleinere Dateien auf</translation>
    </message>
    <message>
        <source>the column &apos;%1&apos; occurs twice</source>
        <translation>die Spalte „%1“ kommt doppelt vor</translation>
    </message>
    <message>
        <source>give every row the same number of cells; put a cell that contains a comma in quotes</source>
        <translation>geben Sie jeder Zeile gleich viele Zellen; setzen Sie eine Zelle mit einem Komma in Anführungszeichen</translation>
    </message>
    <message>
        <source>name of the cohort</source>
        <translation>Name der Gruppe</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a role that can be imported</source>
        <translation>„%1“ ist keine Rolle, die importiert werden kann</translation>
    </message>
    <message>
        <source>write trainee or educator; give other roles on the page People</source>
        <translation>schreiben Sie trainee oder educator; andere Rollen vergeben Sie auf der Seite „Personen“</translation>
    </message>
    <message>
        <source>sourcedId &apos;%1&apos; occurs twice</source>
        <translation>sourcedId „%1“ kommt doppelt vor</translation>
    </message>
    <message>
        <source>the title &apos;%1&apos; is also used by %2</source>
        <translation>den Titel „%1“ hat auch %2</translation>
    </message>
    <message>
        <source>give every class a title of its own</source>
        <translation>geben Sie jeder Klasse einen eigenen Titel</translation>
    </message>
    <message>
        <source>login %1 is also used by %2</source>
        <translation>der Anmeldename %1 gehört auch zu %2</translation>
    </message>
    <message>
        <source>%1: there is no store</source>
        <translation>%1: Dort ist kein Datenbestand</translation>
    </message>
    <message>
        <source>create one with `fulcrum db create`, or name another one with --db</source>
        <translation>legen Sie einen mit `fulcrum db create` an, oder nennen Sie einen anderen mit --db</translation>
    </message>
    <message>
        <source>%1: the disk reported an error (%2)</source>
        <translation>%1: Der Datenträger meldet einen Fehler (%2)</translation>
    </message>
    <message>
        <source>there is not enough memory to protect a password (64 MiB are needed); close other programs</source>
        <translation>der Arbeitsspeicher reicht nicht, um ein Passwort zu schützen (64 MiB sind nötig); schließen Sie andere Programme</translation>
    </message>
    <message>
        <source>a part of the recording is damaged (%1)</source>
        <translation>ein Teil der Aufzeichnung ist beschädigt (%1)</translation>
    </message>
    <message>
        <source>a part of a recording holds 1 to %1 records</source>
        <translation>ein Teil einer Aufzeichnung enthält 1 bis %1 Einträge</translation>
    </message>
    <message>
        <source>the program has no schema step %1</source>
        <translation>der Software fehlt der Schemaschritt %1</translation>
    </message>
    <message>
        <source>%1: cannot be created (%2)</source>
        <translation>%1: kann nicht angelegt werden (%2)</translation>
    </message>
    <message>
        <source>make the store&apos;s folder writable and free some space on the disk; nothing was recorded yet</source>
        <translation>machen Sie den Ordner des Datenbestands beschreibbar, und schaffen Sie Platz auf dem Datenträger; aufgezeichnet wurde noch nichts</translation>
    </message>
    <message>
        <source>%1: the store was written by an older program (schema %2, this program uses %3)</source>
        <translation>%1: Der Datenbestand wurde von einer älteren Software geschrieben (Schema %2, diese Software verwendet %3)</translation>
    </message>
    <message>
        <source>choose another name, or open that file</source>
        <translation>wählen Sie einen anderen Namen, oder öffnen Sie jene Datei</translation>
    </message>
    <message>
        <source>%1: you may not read this file</source>
        <translation>%1: Sie dürfen diese Datei nicht lesen</translation>
    </message>
    <message>
        <source>log in to the computer as the file&apos;s owner, or ask them for read permission</source>
        <translation>melden Sie sich am Computer als Eigentümer der Datei an, oder lassen Sie sich das Leserecht geben</translation>
    </message>
    <message>
        <source>create it again with `fulcrum db create`, or start the window and create a programme</source>
        <translation>legen Sie ihn mit `fulcrum db create` neu an, oder starten Sie das Fenster und legen Sie ein Programm an</translation>
    </message>
    <message>
        <source>close every Fulcrum program that uses this store, then try again; nothing was changed</source>
        <translation>schließen Sie jedes Fulcrum, das diesen Datenbestand verwendet, und versuchen Sie es noch einmal; geändert wurde nichts</translation>
    </message>
    <message>
        <source>%1-wal: this is the log of a store that is missing</source>
        <translation>%1-wal: das Protokoll eines Datenbestands, der fehlt</translation>
    </message>
    <message>
        <source>%1 connected; two are needed</source>
        <translation>%1 angeschlossen; nötig sind zwei</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a probability</source>
        <translation>„%1“ ist keine Wahrscheinlichkeit</translation>
    </message>
    <message>
        <source>give a number from 0 to 1</source>
        <translation>geben Sie eine Zahl von 0 bis 1 an</translation>
    </message>
    <message>
        <source>this device is for practice only</source>
        <translation>dieses Gerät dient nur zum Üben</translation>
    </message>
    <message>
        <source>an attempt with a ghost is for practice only</source>
        <translation>ein Versuch mit Schattenbild dient nur zum Üben</translation>
    </message>
    <message>
        <source>an attempt that begins in the middle is for practice only</source>
        <translation>ein Versuch, der mittendrin beginnt, dient nur zum Üben</translation>
    </message>
    <message>
        <source>this moment does not belong to a replay that is open</source>
        <translation>dieser Zeitpunkt gehört zu keiner geöffneten Wiedergabe</translation>
    </message>
    <message>
        <source>the attempt cannot be continued from this moment: the simulation differs from the recording here</source>
        <translation>von diesem Zeitpunkt an kann der Versuch nicht fortgesetzt werden: Die Simulation weicht hier von der Aufzeichnung ab</translation>
    </message>
    <message>
        <source>it was recorded with another version of the program; practise from the beginning</source>
        <translation>er wurde mit einer anderen Version der Software aufgezeichnet; üben Sie von Anfang an</translation>
    </message>
    <message>
        <source>audit row %1</source>
        <translation>Protokollzeile %1</translation>
    </message>
    <message>
        <source>%1: not signed</source>
        <translation>%1: nicht signiert</translation>
    </message>
    <message>
        <source>%1: its signature does not fit</source>
        <translation>%1: Die Signatur passt nicht</translation>
    </message>
    <message>
        <source>%1: signed by the key %2, not by this station&apos;s, %3</source>
        <translation>%1: mit dem Schlüssel %2 signiert, nicht mit dem dieses Arbeitsplatzes, %3</translation>
    </message>
    <message>
        <source>audit rows %1 to %2 are missing</source>
        <translation>die Protokollzeilen %1 bis %2 fehlen</translation>
    </message>
    <message>
        <source>%1: not bound to the row before it</source>
        <translation>%1: nicht mit der Zeile davor verknüpft</translation>
    </message>
    <message>
        <source>%1: changed after it was written</source>
        <translation>%1: nach dem Schreiben geändert</translation>
    </message>
    <message>
        <source>%1: its payload was changed</source>
        <translation>%1: Der Inhalt wurde geändert</translation>
    </message>
    <message>
        <source>audit row %1: only its payload is left</source>
        <translation>Protokollzeile %1: Nur ihr Inhalt ist noch da</translation>
    </message>
    <message>
        <source>audit row %1: enters all records again, although earlier rows have their digests</source>
        <translation>Protokollzeile %1: trägt alle Datensätze neu ein, obwohl frühere Zeilen ihre Prüfsummen enthalten</translation>
    </message>
    <message>
        <source> of attempt %1</source>
        <translation> des Versuchs %1</translation>
    </message>
    <message>
        <source>the audit log has no digests of the records: open the store once for writing, or restore the newest backup</source>
        <translation>das Protokoll enthält keine Prüfsummen der Datensätze: Öffnen Sie den Datenbestand einmal zum Schreiben, oder stellen Sie die neueste Sicherung wieder her</translation>
    </message>
    <message>
        <source>%1: the audit log has no row for it</source>
        <translation>%1: Das Protokoll hat dafür keine Zeile</translation>
    </message>
    <message>
        <source>%1%2: changed since audit row %3</source>
        <translation>%1%2: geändert seit Protokollzeile %3</translation>
    </message>
    <message>
        <source>%1: chunk %2 is missing</source>
        <translation>%1: Block %2 fehlt</translation>
    </message>
    <message>
        <source>%1: chunk %2 is out of order</source>
        <translation>%1: Block %2 ist nicht an seiner Stelle</translation>
    </message>
    <message>
        <source>attempt %1, stream %2</source>
        <translation>Versuch %1, Datenstrom %2</translation>
    </message>
    <message>
        <source>%1: chunk %2 is damaged (%3)</source>
        <translation>%1: Block %2 ist beschädigt (%3)</translation>
    </message>
    <message>
        <source>attempt %1: no stream has the number %2</source>
        <translation>Versuch %1: Es gibt keinen Datenstrom mit der Nummer %2</translation>
    </message>
    <message>
        <source>attempt %1: %2 of its %3 events are there, a part of the record is missing</source>
        <translation>Versuch %1: %2 von %3 Ereignissen sind da, ein Teil der Aufzeichnung fehlt</translation>
    </message>
    <message>
        <source>attempt %1: %2 samples for %3 inputs are there, a part of the record is missing</source>
        <translation>Versuch %1: %2 Messwerte für %3 Eingaben sind da, ein Teil der Aufzeichnung fehlt</translation>
    </message>
    <message>
        <source>attempt %1: product %2 is damaged</source>
        <translation>Versuch %1: Das Ergebnis %2 ist beschädigt</translation>
    </message>
    <message>
        <source>attempt %1: the state that it began with is damaged</source>
        <translation>Versuch %1: Der Zustand, mit dem er begann, ist beschädigt</translation>
    </message>
    <message>
        <source>table %1: a row points to nothing in %2</source>
        <translation>Tabelle %1: Eine Zeile verweist auf nichts in %2</translation>
    </message>
    <message>
        <source>score of attempt %1</source>
        <translation>Bewertung des Versuchs %1</translation>
    </message>
    <message>
        <source>%1: not in the audit chain</source>
        <translation>%1: nicht im Protokoll</translation>
    </message>
    <message>
        <source>scene %1: changed after it was written</source>
        <translation>Szene %1: nach dem Schreiben geändert</translation>
    </message>
    <message>
        <source>attempt %1: its scene is missing</source>
        <translation>Versuch %1: Seine Szene fehlt</translation>
    </message>
    <message>
        <source>decision %1 on %2: not as the audit log has it</source>
        <translation>Entscheidung %1 zu %2: nicht so, wie das Protokoll sie enthält</translation>
    </message>
    <message>
        <source>%1: other users of this machine may open it (run `chmod 600` on it)</source>
        <translation>%1: Andere Benutzer dieses Rechners können sie öffnen (führen Sie `chmod 600` darauf aus)</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>integrity</source>
        <translation>Unversehrtheit</translation>
    </message>
    <message>
        <source>foreign keys</source>
        <translation>Verweise</translation>
    </message>
    <message>
        <source>audit chain</source>
        <translation>Kette des Protokolls</translation>
    </message>
    <message>
        <source>signatures</source>
        <translation>Signaturen</translation>
    </message>
    <message>
        <source>trace checksums</source>
        <translation>Prüfsummen der Aufzeichnungen</translation>
    </message>
    <message>
        <source>records</source>
        <translation>Datensätze</translation>
    </message>
    <message>
        <source>score digests</source>
        <translation>Prüfsummen der Bewertungen</translation>
    </message>
    <message>
        <source>scenes</source>
        <translation>Szenen</translation>
    </message>
    <message>
        <source>decisions</source>
        <translation>Entscheidungen</translation>
    </message>
    <message>
        <source>permissions</source>
        <translation>Zugriffsrechte</translation>
    </message>
    <message>
        <source>copying the store</source>
        <translation>Datenbestand wird kopiert</translation>
    </message>
    <message>
        <source>known head</source>
        <translation>bekannter Kopf</translation>
    </message>
    <message>
        <source>no audit row has the head %1: the store was rewritten, or an older copy is in its place</source>
        <translation>keine Protokollzeile hat den Kopf %1: Der Datenbestand wurde neu geschrieben, oder eine ältere Kopie liegt an seiner Stelle</translation>
    </message>
    <message>
        <source>known key</source>
        <translation>bekannter Schlüssel</translation>
    </message>
    <message>
        <source>the newest audit row is not signed (it should be, by %1): the log was written by somebody else, or the station has a new key</source>
        <translation>die neueste Protokollzeile ist nicht signiert (nötig wäre %1): Jemand anders hat das Protokoll geschrieben, oder der Arbeitsplatz hat einen neuen Schlüssel</translation>
    </message>
    <message>
        <source>the stored state was written by another version of the program, or for another scene</source>
        <translation>der gespeicherte Zustand stammt von einer anderen Version der Software oder gehört zu einer anderen Szene</translation>
    </message>
    <message>
        <source>the stored state ends too early: it does not belong to this scene in this version of the program</source>
        <translation>der gespeicherte Zustand endet zu früh: Er gehört nicht zu dieser Szene in dieser Version der Software</translation>
    </message>
    <message>
        <source>the stored state belongs to another attempt</source>
        <translation>der gespeicherte Zustand gehört zu einem anderen Versuch</translation>
    </message>
    <message>
        <source>needs at least two targets and two raters</source>
        <translation>braucht mindestens zwei Ziele und zwei Beurteiler</translation>
    </message>
    <message>
        <source>a rating is missing</source>
        <translation>eine Beurteilung fehlt</translation>
    </message>
    <message>
        <source>a rating is not a number</source>
        <translation>eine Beurteilung ist keine Zahl</translation>
    </message>
    <message>
        <source>all ratings are equal</source>
        <translation>alle Beurteilungen sind gleich</translation>
    </message>
    <message>
        <source>all targets have the same sum</source>
        <translation>alle Ziele haben dieselbe Summe</translation>
    </message>
    <message>
        <source>name of the programme</source>
        <translation>Name des Programms</translation>
    </message>
    <message>
        <source>%1%2: gone since audit row %3</source>
        <translation>%1%2: fehlt seit Protokollzeile %3</translation>
    </message>
    <message>
        <source>the device reports forces that are not possible</source>
        <translation>das Gerät meldet Kräfte, die nicht möglich sind</translation>
    </message>
    <message>
        <source>the device reports a rate that is not possible</source>
        <translation>das Gerät meldet eine Taktrate, die nicht möglich ist</translation>
    </message>
    <message>
        <source>fulcrum-hapticd is of another version than fulcrum</source>
        <translation>fulcrum-hapticd hat eine andere Version als fulcrum</translation>
    </message>
    <message>
        <source>the curriculum %2 is not installed, but people follow it (how many: %1)</source>
        <translation>das Curriculum %2 ist nicht installiert, aber Personen folgen ihm (Anzahl: %1)</translation>
    </message>
    <message>
        <source>this file says it is %1, but the %1 that people follow (how many: %2) has different content</source>
        <translation>diese Datei nennt sich %1, aber das %1, dem Personen folgen (Anzahl: %2), hat einen anderen Inhalt</translation>
    </message>
    <message>
        <source>the role %1 is not held</source>
        <translation>das Konto hat die Rolle %1 nicht</translation>
    </message>
    <message>
        <source>status %1: an import deletes and deactivates nobody</source>
        <translation>Status %1: Ein Import löscht und deaktiviert niemanden</translation>
    </message>
    <message>
        <source>%1 is not enabled</source>
        <translation>%1 ist nicht freigeschaltet</translation>
    </message>
    <message>
        <source>there is no such user</source>
        <translation>diesen Benutzer gibt es nicht</translation>
    </message>
    <message>
        <source>there is no such class</source>
        <translation>diese Klasse gibt es nicht</translation>
    </message>
    <message>
        <source>the role %1 is not imported</source>
        <translation>die Rolle %1 wird nicht importiert</translation>
    </message>
    <message>
        <source>%1: %2 has no role</source>
        <translation>%1: %2 hat keine Rolle</translation>
    </message>
    <message>
        <source>%1: %2 has the role %3, which is not imported</source>
        <translation>%1: %2 hat die Rolle %3, die nicht importiert wird</translation>
    </message>
    <message>
        <source>begin with a row of names</source>
        <translation>beginnen Sie mit einer Zeile der Namen</translation>
    </message>
    <message>
        <source>%1 cells</source>
        <translation>%1 Zellen</translation>
    </message>
    <message>
        <source>write %1 cells, as in the first row</source>
        <translation>schreiben Sie %1 Zellen, wie in der ersten Zeile</translation>
    </message>
    <message>
        <source>give at most 100,000</source>
        <translation>geben Sie höchstens 100000 an</translation>
    </message>
    <message>
        <source>the trace of attempt %1 is not in this store: it was recorded at the station %2</source>
        <translation>die Aufzeichnung des Versuchs %1 ist nicht in diesem Speicher: Sie wurde an der Station %2 gemacht</translation>
    </message>
    <message>
        <source>the PostgreSQL driver of Qt is missing</source>
        <translation>der PostgreSQL-Treiber von Qt fehlt</translation>
    </message>
    <message>
        <source>install libqt5sql5-psql</source>
        <translation>installieren Sie libqt5sql5-psql</translation>
    </message>
    <message>
        <source>the address of the server %1</source>
        <translation>die Adresse des Servers %1</translation>
    </message>
    <message>
        <source>write it as postgresql://USER@HOST:PORT/DATABASE</source>
        <translation>schreiben Sie sie als postgresql://USER@HOST:PORT/DATABASE</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be read</source>
        <translation>&apos;%1&apos; kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>contains a password, which other users of this machine could read</source>
        <translation>enthält ein Passwort, das andere Benutzer dieses Rechners lesen könnten</translation>
    </message>
    <message>
        <source>leave it out; put it into the file ~/.pgpass (HOST:PORT:DATABASE:USER:PASSWORD, mode 0600), or name such a file in PGPASSFILE</source>
        <translation>lassen Sie es weg; schreiben Sie es in die Datei ~/.pgpass (HOST:PORT:DATABASE:USER:PASSWORD, Rechte 0600), oder nennen Sie eine solche Datei in PGPASSFILE</translation>
    </message>
    <message>
        <source>has the parameter &apos;%1&apos;, which is not known</source>
        <translation>hat den Parameter &apos;%1&apos;, der nicht bekannt ist</translation>
    </message>
    <message>
        <source>host, port and service are; for others use the environment variables of libpq</source>
        <translation>bekannt sind host, port und service; für andere gibt es die Umgebungsvariablen von libpq</translation>
    </message>
    <message>
        <source>contains a quote, a space, a backslash or a semicolon</source>
        <translation>enthält ein Anführungszeichen, ein Leerzeichen, einen Rückstrich oder ein Semikolon</translation>
    </message>
    <message>
        <source>names no database</source>
        <translation>nennt keine Datenbank</translation>
    </message>
    <message>
        <source>check the address, the network, and that the server runs, and try again; nothing is lost</source>
        <translation>prüfen Sie die Adresse, das Netz und ob der Server läuft, und versuchen Sie es noch einmal; nichts ist verloren</translation>
    </message>
    <message>
        <source>put the right password into ~/.pgpass (HOST:PORT:DATABASE:USER:PASSWORD, mode 0600), or name such a file in PGPASSFILE</source>
        <translation>schreiben Sie das richtige Passwort in ~/.pgpass (HOST:PORT:DATABASE:USER:PASSWORD, Rechte 0600), oder nennen Sie eine solche Datei in PGPASSFILE</translation>
    </message>
    <message>
        <source>have the administrator of the server make it: createdb, then `fulcrum server create`</source>
        <translation>lassen Sie sie vom Administrator des Servers anlegen: createdb, dann `fulcrum server create`</translation>
    </message>
    <message>
        <source>the connection must be encrypted: have the server&apos;s administrator turn ssl on</source>
        <translation>die Verbindung muss verschlüsselt sein: Lassen Sie den Administrator des Servers ssl einschalten</translation>
    </message>
    <message>
        <source>have the server&apos;s administrator allow this account from this machine in pg_hba.conf, with hostssl</source>
        <translation>lassen Sie den Administrator des Servers dieses Konto von diesem Rechner aus in pg_hba.conf erlauben, mit hostssl</translation>
    </message>
    <message>
        <source>write the server&apos;s name in the address as its certificate names it, or have its administrator make a certificate for this name</source>
        <translation>schreiben Sie den Namen des Servers in der Adresse so, wie ihn sein Zertifikat nennt, oder lassen Sie seinen Administrator ein Zertifikat für diesen Namen anlegen</translation>
    </message>
    <message>
        <source>the server&apos;s certificate is not known here: ask its administrator for the certificate of the authority that made it, put that into ~/.postgresql/root.crt, or name its file in PGSSLROOTCERT; if it was known before, another machine may answer in the server&apos;s place</source>
        <translation>das Zertifikat des Servers ist hier nicht bekannt: Erbitten Sie von seinem Administrator das Zertifikat der Stelle, die es ausgestellt hat, legen Sie es als ~/.postgresql/root.crt ab oder nennen Sie seine Datei in PGSSLROOTCERT; war es bisher bekannt, antwortet vielleicht ein anderer Rechner an der Stelle des Servers</translation>
    </message>
    <message>
        <source>%1: cannot connect (%2)</source>
        <translation>%1: keine Verbindung (%2)</translation>
    </message>
    <message>
        <source>the connection was lost</source>
        <translation>die Verbindung ging verloren</translation>
    </message>
    <message>
        <source>this account of the server may not do that</source>
        <translation>dieses Konto des Servers darf das nicht</translation>
    </message>
    <message>
        <source>refused by a rule of the server</source>
        <translation>von einer Regel des Servers abgelehnt</translation>
    </message>
    <message>
        <source>sync again; if it is refused again, `fulcrum db check` looks at this store</source>
        <translation>gleichen Sie wieder ab; wird es erneut abgelehnt, prüft `fulcrum db check` diesen Speicher</translation>
    </message>
    <message>
        <source>another station is writing the same rows</source>
        <translation>eine andere Station schreibt dieselben Zeilen</translation>
    </message>
    <message>
        <source>sync again</source>
        <translation>gleichen Sie wieder ab</translation>
    </message>
    <message>
        <source>the server has no room or no connection left</source>
        <translation>der Server hat keinen Platz oder keine freie Verbindung mehr</translation>
    </message>
    <message>
        <source>tell its administrator, then sync again; what was stored before is intact</source>
        <translation>sagen Sie es seinem Administrator und gleichen Sie dann wieder ab; was zuvor gespeichert war, ist unversehrt</translation>
    </message>
    <message>
        <source>%1: the server refused (%2)</source>
        <translation>%1: vom Server abgelehnt (%2)</translation>
    </message>
    <message>
        <source>tell its administrator</source>
        <translation>sagen Sie es seinem Administrator</translation>
    </message>
    <message>
        <source>station %1, audit row %2</source>
        <translation>Station %1, Protokollzeile %2</translation>
    </message>
    <message>
        <source>%1: its payload is gone, and no erasure is in the audit log</source>
        <translation>%1: ihr Inhalt fehlt, und im Protokoll steht keine Löschung</translation>
    </message>
    <message>
        <source>%1: has no person %2</source>
        <translation>%1: hat keine Person %2</translation>
    </message>
    <message>
        <source>give the id (UUID) that `fulcrum report --format json` and exports print</source>
        <translation>geben Sie die Kennung (UUID) an, die `fulcrum report --format json` und Exporte ausgeben</translation>
    </message>
    <message>
        <source>neither this store nor the server has a programme</source>
        <translation>weder dieser Speicher noch der Server hat ein Programm</translation>
    </message>
    <message>
        <source>make the programme at one station (start `fulcrum`, Create programme) and sync that one first</source>
        <translation>legen Sie das Programm an einer Station an (`fulcrum` starten, Programm anlegen) und gleichen Sie diese zuerst ab</translation>
    </message>
    <message>
        <source>this store belongs to another programme than the server</source>
        <translation>dieser Speicher gehört zu einem anderen Programm als der Server</translation>
    </message>
    <message>
        <source>name the right server; a further station begins with an empty store (`fulcrum db create`) and gets its people by sync</source>
        <translation>nennen Sie den richtigen Server; eine weitere Station beginnt mit einem leeren Speicher (`fulcrum db create`) und erhält ihre Personen durch den Abgleich</translation>
    </message>
    <message>
        <source>the audit log of this store is not the one that the server knows (row %1): an older copy is in its place, or it was rewritten</source>
        <translation>das Protokoll dieses Speichers ist nicht das, das der Server kennt (Zeile %1): An seiner Stelle liegt eine ältere Kopie, oder es wurde umgeschrieben</translation>
    </message>
    <message>
        <source>restore the newest backup; if this is the newest, keep this file and begin with an empty store (`fulcrum db create`), which joins as a further station and gets people and attempts by sync; nothing was transferred</source>
        <translation>stellen Sie die neueste Sicherung wieder her; ist dies die neueste, behalten Sie diese Datei und beginnen Sie mit einem leeren Speicher (`fulcrum db create`), der als weitere Station beitritt und Personen und Versuche durch den Abgleich erhält; es wurde nichts übertragen</translation>
    </message>
    <message>
        <source>the demonstration is never synchronised</source>
        <translation>die Vorführung wird nie abgeglichen</translation>
    </message>
    <message>
        <source>name the store of the programme with --db</source>
        <translation>nennen Sie mit --db den Speicher des Programms</translation>
    </message>
    <message>
        <source>%1: there without an audit row (if a sync was cut off, the station&apos;s next one brings it, unless its store was replaced by an older copy)</source>
        <translation>%1: vorhanden ohne Protokollzeile (wurde ein Abgleich unterbrochen, bringt sie der nächste dieser Station, wenn nicht eine ältere Kopie ihren Speicher ersetzt hat)</translation>
    </message>
    <message>
        <source>%1: not as the station that made it has signed it</source>
        <translation>%1: nicht so, wie die Station es unterschrieben hat</translation>
    </message>
    <message>
        <source>%1: PostgreSQL %2 is too old</source>
        <translation>%1: PostgreSQL %2 ist zu alt</translation>
    </message>
    <message>
        <source>upgrade the server to PostgreSQL 12 or newer</source>
        <translation>bringen Sie den Server auf PostgreSQL 12 oder neuer</translation>
    </message>
    <message>
        <source>%1: made by a newer program (schema %2, this program knows %3)</source>
        <translation>%1: von einem neueren Programm angelegt (Schema %2, dieses Programm kennt %3)</translation>
    </message>
    <message>
        <source>update Fulcrum on this station, then sync again; nothing is lost</source>
        <translation>bringen Sie Fulcrum an dieser Station auf den neuesten Stand und gleichen Sie dann wieder ab; nichts ist verloren</translation>
    </message>
    <message>
        <source>a trigger of the schema has no form for a server</source>
        <translation>ein Trigger des Schemas hat keine Form für einen Server</translation>
    </message>
    <message>
        <source>report this: the program is incomplete</source>
        <translation>melden Sie das: Das Programm ist unvollständig</translation>
    </message>
    <message>
        <source>%1: has tables of another program</source>
        <translation>%1: enthält Tabellen eines anderen Programms</translation>
    </message>
    <message>
        <source>make a database of its own (createdb) and name that</source>
        <translation>legen Sie eine eigene Datenbank an (createdb) und nennen Sie diese</translation>
    </message>
    <message>
        <source>%1: is not a programme server</source>
        <translation>%1: ist kein Programmserver</translation>
    </message>
    <message>
        <source>have its administrator run `fulcrum server create --to %1`</source>
        <translation>lassen Sie seinen Administrator `fulcrum server create --to %1` ausführen</translation>
    </message>
    <message>
        <source>%1: schema %2 is older than this program&apos;s %3</source>
        <translation>%1: Schema %2 ist älter als das dieses Programms, %3</translation>
    </message>
    <message>
        <source>have its administrator run `fulcrum server create --to %1` with this program; nothing is lost</source>
        <translation>lassen Sie seinen Administrator `fulcrum server create --to %1` mit diesem Programm ausführen; nichts ist verloren</translation>
    </message>
    <message>
        <source>the store has no table %1</source>
        <translation>der Speicher hat keine Tabelle %1</translation>
    </message>
    <message>
        <source>name the server: --to postgresql://USER@HOST:PORT/DATABASE</source>
        <translation>nennen Sie den Server: --to postgresql://USER@HOST:PORT/DATABASE</translation>
    </message>
    <message>
        <source>The device could not be opened again: %1; %2.</source>
        <translation>Das Gerät konnte nicht wieder geöffnet werden: %1; %2.</translation>
    </message>
    <message>
        <source>check its cable and power</source>
        <translation>prüfen Sie Kabel und Stromversorgung</translation>
    </message>
    <message>
        <source>%1 It is tried again.</source>
        <translation>%1 Es wird wieder versucht.</translation>
    </message>
    <message>
        <source>The device needs calibration. Put the stylus of a Touch into its inkwell and take it out after two seconds; move the handle of another device slowly to each end of its range. Where that does not help, calibrate it with the maker&apos;s program.</source>
        <translation>Das Gerät muss kalibriert werden. Stecken Sie den Stift eines Touch in seine Halterung und nehmen Sie ihn nach zwei Sekunden heraus; bewegen Sie den Griff eines anderen Geräts langsam an jedes Ende seines Bereichs. Hilft das nicht, kalibrieren Sie es mit dem Programm des Herstellers.</translation>
    </message>
    <message>
        <source>The motors of the device are too warm. Let go of it for half a minute, then resume.</source>
        <translation>Die Motoren des Geräts sind zu warm. Lassen Sie es eine halbe Minute los und fahren Sie dann fort.</translation>
    </message>
    <message>
        <source>The device refused a force as too large. Resume; where it happens again, lower the force given to the hand on the page Settings.</source>
        <translation>Das Gerät hat eine Kraft als zu groß abgelehnt. Fahren Sie fort; geschieht es wieder, verringern Sie auf der Seite Einstellungen die Kraft an der Hand.</translation>
    </message>
    <message>
        <source>The device was moved too fast and switched its motors off. Hold it still.</source>
        <translation>Das Gerät wurde zu schnell bewegt und hat seine Motoren abgeschaltet. Halten Sie es ruhig.</translation>
    </message>
    <message>
        <source>Force is switched off at the device. Press its force button, or let its hand sensor see your hand.</source>
        <translation>Die Kraft ist am Gerät ausgeschaltet. Drücken Sie seine Krafttaste, oder legen Sie die Hand an seinen Handsensor.</translation>
    </message>
    <message>
        <source>The device does not answer. Check its cable and power; unplug it and connect it again.</source>
        <translation>Das Gerät antwortet nicht. Prüfen Sie Kabel und Stromversorgung; ziehen Sie es ab und schließen Sie es wieder an.</translation>
    </message>
    <message>
        <source>The maker&apos;s driver of the device has stopped reading it. Unplug the device and connect it again.</source>
        <translation>Der Treiber des Herstellers liest das Gerät nicht mehr. Ziehen Sie das Gerät ab und schließen Sie es wieder an.</translation>
    </message>
    <message>
        <source>The maker&apos;s driver of the device refused a request. Install the driver&apos;s newest version; its messages are on standard error.</source>
        <translation>Der Treiber des Herstellers hat eine Anfrage abgelehnt. Installieren Sie seine neueste Version; seine Meldungen stehen auf der Standardfehlerausgabe.</translation>
    </message>
    <message>
        <source>3D Systems Touch</source>
        <translation>3D Systems Touch</translation>
    </message>
    <message>
        <source>install OpenHaptics for Linux and the Touch driver of 3D Systems, then run `sudo ldconfig`</source>
        <translation>installieren Sie OpenHaptics für Linux und den Touch-Treiber von 3D Systems, und führen Sie dann `sudo ldconfig` aus</translation>
    </message>
    <message>
        <source>install that library: libPhantomIOLib42.so comes with the Touch driver, libncurses.so.5 and libtinfo.so.5 with the packages libncurses5 and libtinfo5</source>
        <translation>installieren Sie diese Bibliothek: libPhantomIOLib42.so gehört zum Touch-Treiber, libncurses.so.5 und libtinfo.so.5 zu den Paketen libncurses5 und libtinfo5</translation>
    </message>
    <message>
        <source>write the line SUBSYSTEMS==&quot;usb&quot;, ATTRS{idVendor}==&quot;2988&quot;, MODE=&quot;0660&quot;, TAG+=&quot;uaccess&quot; to /etc/udev/rules.d/70-fulcrum-touch.rules, then unplug the device and connect it again</source>
        <translation>schreiben Sie die Zeile SUBSYSTEMS==&quot;usb&quot;, ATTRS{idVendor}==&quot;2988&quot;, MODE=&quot;0660&quot;, TAG+=&quot;uaccess&quot; in /etc/udev/rules.d/70-fulcrum-touch.rules, ziehen Sie dann das Gerät ab und schließen Sie es wieder an</translation>
    </message>
    <message>
        <source>Force Dimension, Novint Falcon</source>
        <translation>Force Dimension, Novint Falcon</translation>
    </message>
    <message>
        <source>install the Force Dimension SDK and name its folder in FDSDK, or copy its libdrd.so to /usr/local/lib and run `sudo ldconfig`</source>
        <translation>installieren Sie das SDK von Force Dimension und nennen Sie seinen Ordner in FDSDK, oder kopieren Sie seine libdrd.so nach /usr/local/lib und führen Sie `sudo ldconfig` aus</translation>
    </message>
    <message>
        <source>install that library: libusb-1.0.so.0 comes with the package libusb-1.0-0</source>
        <translation>installieren Sie diese Bibliothek: libusb-1.0.so.0 gehört zum Paket libusb-1.0-0</translation>
    </message>
    <message>
        <source>write the lines SUBSYSTEMS==&quot;usb&quot;, ATTRS{idVendor}==&quot;1451&quot;, MODE=&quot;0660&quot;, TAG+=&quot;uaccess&quot; and SUBSYSTEMS==&quot;usb&quot;, ATTRS{idVendor}==&quot;0403&quot;, ATTRS{idProduct}==&quot;cb48&quot;, MODE=&quot;0660&quot;, TAG+=&quot;uaccess&quot; to /etc/udev/rules.d/70-fulcrum-force-dimension.rules, then unplug the device and connect it again</source>
        <translation>schreiben Sie die Zeilen SUBSYSTEMS==&quot;usb&quot;, ATTRS{idVendor}==&quot;1451&quot;, MODE=&quot;0660&quot;, TAG+=&quot;uaccess&quot; und SUBSYSTEMS==&quot;usb&quot;, ATTRS{idVendor}==&quot;0403&quot;, ATTRS{idProduct}==&quot;cb48&quot;, MODE=&quot;0660&quot;, TAG+=&quot;uaccess&quot; in /etc/udev/rules.d/70-fulcrum-force-dimension.rules, ziehen Sie dann das Gerät ab und schließen Sie es wieder an</translation>
    </message>
    <message>
        <source>the maker&apos;s library is not installed</source>
        <translation>die Bibliothek des Herstellers ist nicht installiert</translation>
    </message>
    <message>
        <source>the maker&apos;s library needs another one that is missing</source>
        <translation>die Bibliothek des Herstellers braucht eine andere, die fehlt</translation>
    </message>
    <message>
        <source>the maker&apos;s library lacks a function that Fulcrum needs</source>
        <translation>der Bibliothek des Herstellers fehlt eine Funktion, die Fulcrum braucht</translation>
    </message>
    <message>
        <source>the maker&apos;s library cannot be loaded</source>
        <translation>die Bibliothek des Herstellers lässt sich nicht laden</translation>
    </message>
    <message>
        <source>install the newest version of the maker&apos;s driver</source>
        <translation>installieren Sie die neueste Version des Treibers des Herstellers</translation>
    </message>
    <message>
        <source>&apos;%1&apos; does not number the devices</source>
        <translation>„%1“ nummeriert die Geräte nicht</translation>
    </message>
    <message>
        <source>write force-dimension:LEFT,RIGHT with numbers from 0 on, for example force-dimension:1,0</source>
        <translation>schreiben Sie force-dimension:LINKS,RECHTS mit Nummern ab 0, zum Beispiel force-dimension:1,0</translation>
    </message>
    <message>
        <source>&apos;%1&apos; does not give each hand a device of its own</source>
        <translation>„%1“ gibt nicht jeder Hand ein eigenes Gerät</translation>
    </message>
    <message>
        <source>write force-dimension:LEFT,RIGHT, for example force-dimension:1,0</source>
        <translation>schreiben Sie force-dimension:LINKS,RECHTS, zum Beispiel force-dimension:1,0</translation>
    </message>
    <message>
        <source>the device does not open: %1</source>
        <translation>das Gerät lässt sich nicht öffnen: %1</translation>
    </message>
    <message>
        <source>check its cable and power, and end other programs that use it</source>
        <translation>prüfen Sie Kabel und Stromversorgung, und beenden Sie andere Programme, die es verwenden</translation>
    </message>
    <message>
        <source>force cannot be switched on: %1</source>
        <translation>die Kraft lässt sich nicht einschalten: %1</translation>
    </message>
    <message>
        <source>test the device with a program of the maker&apos;s SDK</source>
        <translation>prüfen Sie das Gerät mit einem Programm aus dem SDK des Herstellers</translation>
    </message>
    <message>
        <source>no device was found</source>
        <translation>es wurde kein Gerät gefunden</translation>
    </message>
    <message>
        <source>connect it and its power supply</source>
        <translation>schließen Sie es und seine Stromversorgung an</translation>
    </message>
    <message>
        <source>no new process can be started</source>
        <translation>es kann kein neuer Prozess gestartet werden</translation>
    </message>
    <message>
        <source>close other programs</source>
        <translation>schließen Sie andere Programme</translation>
    </message>
    <message>
        <source>the program that opens the device ended</source>
        <translation>das Programm, das das Gerät öffnet, wurde beendet</translation>
    </message>
    <message>
        <source>the device did not open within 5 s</source>
        <translation>das Gerät öffnete sich nicht innerhalb von 5 s</translation>
    </message>
    <message>
        <source>unplug it, connect it again</source>
        <translation>ziehen Sie es ab und schließen Sie es wieder an</translation>
    </message>
    <message>
        <source>lost the device</source>
        <translation>hat das Gerät verloren</translation>
    </message>
    <message>
        <source>&apos;%1&apos; does not name the devices</source>
        <translation>„%1“ nennt die Geräte nicht</translation>
    </message>
    <message>
        <source>write touch:LEFT,RIGHT with the names that the maker&apos;s setup program shows</source>
        <translation>schreiben Sie touch:LINKS,RECHTS mit den Namen, die das Einrichtungsprogramm des Herstellers zeigt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; names one device for both hands</source>
        <translation>„%1“ nennt für beide Hände dasselbe Gerät</translation>
    </message>
    <message>
        <source>give each hand a device of its own</source>
        <translation>geben Sie jeder Hand ein eigenes Gerät</translation>
    </message>
    <message>
        <source>the maker&apos;s driver reports %1</source>
        <translation>der Treiber des Herstellers meldet %1</translation>
    </message>
    <message>
        <source>install the licence of OpenHaptics</source>
        <translation>installieren Sie die Lizenz von OpenHaptics</translation>
    </message>
    <message>
        <source>end the other program that uses the device</source>
        <translation>beenden Sie das andere Programm, das das Gerät verwendet</translation>
    </message>
    <message>
        <source>the device does not answer: %1</source>
        <translation>das Gerät antwortet nicht: %1</translation>
    </message>
    <message>
        <source>check its cable and power, then test it with the maker&apos;s Touch Diagnostic</source>
        <translation>prüfen Sie Kabel und Stromversorgung, dann das Gerät mit Touch Diagnostic des Herstellers</translation>
    </message>
    <message>
        <source>check the device&apos;s name in the maker&apos;s Touch Setup; touch:LEFT,RIGHT names devices</source>
        <translation>prüfen Sie den Namen des Geräts in Touch Setup des Herstellers; touch:LINKS,RECHTS nennt Geräte</translation>
    </message>
    <message>
        <source>test the device with the maker&apos;s Touch Diagnostic</source>
        <translation>prüfen Sie das Gerät mit Touch Diagnostic des Herstellers</translation>
    </message>
    <message>
        <source>the maker&apos;s driver does not start: %1</source>
        <translation>der Treiber des Herstellers startet nicht: %1</translation>
    </message>
    <message>
        <source>unplug the device, connect it again and test it with Touch Diagnostic</source>
        <translation>ziehen Sie das Gerät ab, schließen Sie es wieder an und prüfen Sie es mit Touch Diagnostic</translation>
    </message>
    <message>
        <source>%1; %2 may not be opened: %3</source>
        <translation>%1; %2 darf nicht geöffnet werden: %3</translation>
    </message>
    <message>
        <source>an item is listed twice</source>
        <translation>ein Punkt ist doppelt aufgeführt</translation>
    </message>
    <message>
        <source>list every item once</source>
        <translation>führen Sie jeden Punkt einmal auf</translation>
    </message>
    <message>
        <source>no observer form %1 is installed</source>
        <translation>kein Beobachtungsbogen %1 ist installiert</translation>
    </message>
    <message>
        <source>name the id of a file of assets/forms</source>
        <translation>nennen Sie die id einer Datei aus assets/forms</translation>
    </message>
    <message>
        <source>the form %1 is not filled in blind</source>
        <translation>der Bogen %1 wird nicht verblindet ausgefüllt</translation>
    </message>
    <message>
        <source>leave blind out, or choose a form with &quot;blind&quot;: true</source>
        <translation>lassen Sie blind weg, oder wählen Sie einen Bogen mit &quot;blind&quot;: true</translation>
    </message>
    <message>
        <source>%1 is not an item of the form %2</source>
        <translation>%1 ist kein Punkt des Bogens %2</translation>
    </message>
    <message>
        <source>name items of the form by their id</source>
        <translation>nennen Sie Punkte des Bogens mit ihrer id</translation>
    </message>
    <message>
        <source>is outside the scale of the item %1 (is %2)</source>
        <translation>liegt außerhalb der Skala des Punkts %1 (ist %2)</translation>
    </message>
    <message>
        <source>use a mean from %1 to %2</source>
        <translation>verwenden Sie einen Mittelwert von %1 bis %2</translation>
    </message>
    <message>
        <source>the goal names a task or metric that is too long</source>
        <translation>das Ziel nennt eine Aufgabe oder Kennzahl, deren Name zu lang ist</translation>
    </message>
    <message>
        <source>name a task and one of its metrics</source>
        <translation>nennen Sie eine Aufgabe und eine ihrer Kennzahlen</translation>
    </message>
    <message>
        <source>the number of attempts a week is out of range</source>
        <translation>die Zahl der Versuche pro Woche liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>give a whole number from 1 to %1</source>
        <translation>geben Sie eine ganze Zahl von 1 bis %1 an</translation>
    </message>
    <message>
        <source>a goal of attempts a week has no metric and no day</source>
        <translation>ein Ziel in Versuchen pro Woche hat keine Kennzahl und keinen Tag</translation>
    </message>
    <message>
        <source>leave them out</source>
        <translation>lassen Sie beides weg</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a metric that a goal can be set for</source>
        <translation>&apos;%1&apos; ist keine Kennzahl, für die man ein Ziel setzen kann</translation>
    </message>
    <message>
        <source>choose a task and one of its metrics</source>
        <translation>wählen Sie eine Aufgabe und eine ihrer Kennzahlen</translation>
    </message>
    <message>
        <source>the value of the goal is not a number</source>
        <translation>der Wert des Ziels ist keine Zahl</translation>
    </message>
    <message>
        <source>give a number in the unit of the metric</source>
        <translation>geben Sie eine Zahl in der Einheit der Kennzahl an</translation>
    </message>
    <message>
        <source>the day of the goal is in the past or too far away</source>
        <translation>der Tag des Ziels ist vergangen oder zu weit entfernt</translation>
    </message>
    <message>
        <source>choose a day from today to %1 days from now</source>
        <translation>wählen Sie einen Tag von heute bis in %1 Tagen</translation>
    </message>
    <message>
        <source>the goal was dropped or changed already</source>
        <translation>das Ziel wurde schon aufgegeben oder geändert</translation>
    </message>
    <message>
        <source>open the page again</source>
        <translation>öffnen Sie die Seite erneut</translation>
    </message>
    <message>
        <source>you have %1 goals already</source>
        <translation>Sie haben schon %1 Ziele</translation>
    </message>
    <message>
        <source>change or drop one of them</source>
        <translation>ändern Sie eines, oder geben Sie eines auf</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not the address of a record store</source>
        <translation>&quot;%1&quot; ist keine Adresse eines Record Stores</translation>
    </message>
    <message>
        <source>give its https address without credentials, such as https://lrs.example/xapi; http only on this machine</source>
        <translation>geben Sie seine https-Adresse ohne Zugangsdaten an, etwa https://lrs.example/xapi; http nur auf diesem Rechner</translation>
    </message>
    <message>
        <source>the record store refuses the credentials</source>
        <translation>der Record Store lehnt die Zugangsdaten ab</translation>
    </message>
    <message>
        <source>correct the file; what waits is kept</source>
        <translation>berichtigen Sie die Datei; was wartet, bleibt erhalten</translation>
    </message>
    <message>
        <source>name the record store: --to https://lrs.example/xapi</source>
        <translation>nennen Sie den Record Store: --to https://lrs.example/xapi</translation>
    </message>
    <message>
        <source>the file of the credentials cannot be read</source>
        <translation>die Datei mit den Zugangsdaten ist nicht lesbar</translation>
    </message>
    <message>
        <source>make it, one line KEY:SECRET, with `chmod 600`</source>
        <translation>legen Sie sie an, eine Zeile KEY:SECRET, mit `chmod 600`</translation>
    </message>
    <message>
        <source>others can read the file of the credentials, or it is not yours</source>
        <translation>andere können die Datei mit den Zugangsdaten lesen, oder sie gehört nicht Ihnen</translation>
    </message>
    <message>
        <source>run `chmod 600` on it</source>
        <translation>führen Sie `chmod 600` für sie aus</translation>
    </message>
    <message>
        <source>the file of the credentials does not hold KEY:SECRET</source>
        <translation>die Datei mit den Zugangsdaten enthält kein KEY:SECRET</translation>
    </message>
    <message>
        <source>write one line: the key, a colon, the secret</source>
        <translation>schreiben Sie eine Zeile: den Schlüssel, einen Doppelpunkt, das Geheimnis</translation>
    </message>
    <message>
        <source>the demonstration is never sent anywhere</source>
        <translation>die Demonstration wird nirgendwohin gesendet</translation>
    </message>
    <message>
        <source>name the store of the programme</source>
        <translation>nennen Sie den Datenbestand des Programms</translation>
    </message>
    <message>
        <source>the server&apos;s account &quot;%1&quot; %2; have the owner of the server&apos;s database run `fulcrum server grant LOGIN`, and connect with the account that it names</source>
        <translation>das Konto „%1“ des Servers %2; lassen Sie den Eigentümer der Datenbank `fulcrum server grant ANMELDENAME` ausführen, und verbinden Sie sich mit dem Konto, das dieser Befehl nennt</translation>
    </message>
    <message>
        <source>is not that of an active person</source>
        <translation>gehört keiner aktiven Person</translation>
    </message>
    <message>
        <source>has no role that this person holds</source>
        <translation>hat keine Rolle, die diese Person innehat</translation>
    </message>
    <message>
        <source>name the account that the administrator of the server made for this station or this person; if its access was withdrawn, ask the server&apos;s owner for a new token (`fulcrum server enrol`)</source>
        <translation>nennen Sie das Konto, das der Administrator des Servers für diese Station oder diese Person angelegt hat; wurde sein Zugang beendet, lassen Sie sich vom Eigentümer des Servers ein neues Token geben (`fulcrum server enrol`)</translation>
    </message>
    <message>
        <source>nothing is lost; try again when the server can be reached</source>
        <translation>nichts ist verloren; versuchen Sie es wieder, sobald der Server erreichbar ist</translation>
    </message>
    <message>
        <source>a station&apos;s account has to be a member of fulcrum_station, a person&apos;s is made by `fulcrum server grant`; create, grant and erase need the database&apos;s owner</source>
        <translation>das Konto einer Station muss Mitglied von fulcrum_station sein, das einer Person legt `fulcrum server grant` an; create, grant und erase verlangen den Eigentümer der Datenbank</translation>
    </message>
    <message>
        <source>the programme server is only read here; do it at a station, with its own store</source>
        <translation>der Programmserver wird hier nur gelesen; tun Sie es an einer Station mit deren eigenem Speicher</translation>
    </message>
    <message>
        <source>%1: this is a programme server, not a file</source>
        <translation>%1: das ist ein Programmserver, keine Datei</translation>
    </message>
    <message>
        <source>name the station&apos;s own store; `fulcrum server` has the commands for a server</source>
        <translation>nennen Sie den eigenen Speicher der Station; die Befehle für einen Server sind `fulcrum server`</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is the name of one at this station and of another one on the server; neither is transferred until one of them is renamed</source>
        <translation>%1: „%2“ heißt eines an dieser Station und ein anderes auf dem Server; keines wird übertragen, bis eines umbenannt ist</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; was changed here and on the server; the server&apos;s is kept, and the audit log has both</source>
        <translation>%1: „%2“ wurde hier und auf dem Server geändert; das des Servers gilt, und das Protokoll hat beide</translation>
    </message>
    <message>
        <source>%1 of this station that wait until what they belong to can be transferred: %2</source>
        <translation>%1 dieser Station, die warten, bis das übertragen werden kann, wozu sie gehören: %2</translation>
    </message>
    <message>
        <source>%1 of the server that wait until what they belong to can be transferred: %2</source>
        <translation>%1 des Servers, die warten, bis das übertragen werden kann, wozu sie gehören: %2</translation>
    </message>
    <message>
        <source>%1: has no person with the login %2</source>
        <translation>%1: hat keine Person mit dem Anmeldenamen %2</translation>
    </message>
    <message>
        <source>sync the station that knows the person first</source>
        <translation>gleichen Sie zuerst die Station ab, die diese Person kennt</translation>
    </message>
    <message>
        <source>%1 is not an active trainee, educator or director</source>
        <translation>%1 ist weder Lernende(r) noch Ausbilder noch Programmleitung oder ist nicht aktiv</translation>
    </message>
    <message>
        <source>accounts of a server are for these; give the person the role first</source>
        <translation>Konten eines Servers sind für diese Rollen; geben Sie der Person zuerst eine davon</translation>
    </message>
    <message>
        <source>programme</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>stations</source>
        <translation>Stationen</translation>
    </message>
    <message>
        <source>people</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>cohorts</source>
        <translation>Gruppen</translation>
    </message>
    <message>
        <source>accepted files</source>
        <translation>anerkannte Dateien</translation>
    </message>
    <message>
        <source>forms</source>
        <translation>Bögen</translation>
    </message>
    <message>
        <source>attempts</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>scores</source>
        <translation>Wertungen</translation>
    </message>
    <message>
        <source>voids</source>
        <translation>Aufhebungen</translation>
    </message>
    <message>
        <source>reassignments</source>
        <translation>Umbuchungen</translation>
    </message>
    <message>
        <source>comments</source>
        <translation>Kommentare</translation>
    </message>
    <message>
        <source>corrections asked for</source>
        <translation>erbetene Berichtigungen</translation>
    </message>
    <message>
        <source>decisions on standings</source>
        <translation>Entscheidungen über den Stand</translation>
    </message>
    <message>
        <source>moves of curriculum</source>
        <translation>Wechsel des Curriculums</translation>
    </message>
    <message>
        <source>ratings</source>
        <translation>Bewertungen</translation>
    </message>
    <message>
        <source>released ratings</source>
        <translation>freigegebene Bewertungen</translation>
    </message>
    <message>
        <source>who saw names of attempts to be rated</source>
        <translation>Angaben, wer Namen zu bewertender Versuche sah</translation>
    </message>
    <message>
        <source>has no meaning with a programme server</source>
        <translation>hat bei einem Programmserver keine Bedeutung</translation>
    </message>
    <message>
        <source>put the password into ~/.pgpass (HOST:PORT:DATABASE:USER:PASSWORD, mode 0600), or name such a file in PGPASSFILE</source>
        <translation>tragen Sie das Passwort in ~/.pgpass ein (HOST:PORT:DATABASE:USER:PASSWORD, Modus 0600), oder nennen Sie eine solche Datei in PGPASSFILE</translation>
    </message>
    <message>
        <source>the server&apos;s account belongs to %1</source>
        <translation>das Konto des Servers gehört %1</translation>
    </message>
    <message>
        <source>leave --as out, or name the account of that person in the address</source>
        <translation>lassen Sie --as weg, oder nennen Sie in der Adresse das Konto dieser Person</translation>
    </message>
    <message>
        <source>game controller</source>
        <translation>Gamecontroller</translation>
    </message>
    <message>
        <source>the library SDL 2 does not answer</source>
        <translation>die Bibliothek SDL 2 antwortet nicht</translation>
    </message>
    <message>
        <source>unplug the controller, wait ten seconds and connect it again</source>
        <translation>ziehen Sie den Controller ab, warten Sie zehn Sekunden und schließen Sie ihn wieder an</translation>
    </message>
    <message>
        <source>the library SDL 2 does not start: %1</source>
        <translation>die Bibliothek SDL 2 startet nicht: %1</translation>
    </message>
    <message>
        <source>%1 cannot be opened: %2</source>
        <translation>%1 lässt sich nicht öffnen: %2</translation>
    </message>
    <message>
        <source>close other programs that use it; on Linux your account needs the right to read /dev/input/event*</source>
        <translation>schließen Sie andere Programme, die ihn benutzen; unter Linux braucht Ihr Konto das Recht, /dev/input/event* zu lesen</translation>
    </message>
    <message>
        <source>SDL does not know the sticks and buttons of %1</source>
        <translation>SDL kennt die Sticks und Tasten von %1 nicht</translation>
    </message>
    <message>
        <source>set SDL_GAMECONTROLLERCONFIG to its mapping, or use another controller</source>
        <translation>setzen Sie SDL_GAMECONTROLLERCONFIG auf seine Belegung, oder verwenden Sie einen anderen Controller</translation>
    </message>
    <message>
        <source>none is connected</source>
        <translation>keiner ist angeschlossen</translation>
    </message>
    <message>
        <source>connect one and switch it on, or use mouse and keyboard</source>
        <translation>schließen Sie einen an und schalten Sie ihn ein, oder verwenden Sie Maus und Tastatur</translation>
    </message>
    <message>
        <source>none of the name %1 is connected</source>
        <translation>keiner mit dem Namen %1 ist angeschlossen</translation>
    </message>
    <message>
        <source>connect it and switch it on, or use mouse and keyboard</source>
        <translation>schließen Sie ihn an und schalten Sie ihn ein, oder verwenden Sie Maus und Tastatur</translation>
    </message>
    <message>
        <source>%1 does not answer. Unplug it, wait ten seconds and connect it again.</source>
        <translation>%1 antwortet nicht. Ziehen Sie ihn ab, warten Sie zehn Sekunden und schließen Sie ihn wieder an.</translation>
    </message>
    <message>
        <source>%1 is not connected. Connect it again, switch it on, or charge its battery.</source>
        <translation>%1 ist nicht verbunden. Schließen Sie ihn wieder an, schalten Sie ihn ein, oder laden Sie seinen Akku.</translation>
    </message>
    <message>
        <source>A stick of %1 is not in its middle, so it moves nothing. Let go of it; if it stays, connect the controller again without touching it.</source>
        <translation>Ein Stick von %1 ist nicht in der Mitte und bewegt deshalb nichts. Lassen Sie ihn los; bleibt es so, schließen Sie den Controller neu an, ohne ihn zu berühren.</translation>
    </message>
    <message>
        <source>the library SDL 2 is not installed</source>
        <translation>die Bibliothek SDL 2 ist nicht installiert</translation>
    </message>
    <message>
        <source>the library SDL 2 needs another one that is missing</source>
        <translation>die Bibliothek SDL 2 braucht eine andere, die fehlt</translation>
    </message>
    <message>
        <source>the library SDL 2 lacks a function that Fulcrum needs</source>
        <translation>der Bibliothek SDL 2 fehlt eine Funktion, die Fulcrum braucht</translation>
    </message>
    <message>
        <source>the library SDL 2 cannot be loaded</source>
        <translation>die Bibliothek SDL 2 lässt sich nicht laden</translation>
    </message>
    <message>
        <source>install the newest libSDL2-2.0.so.0: on Debian and Ubuntu the package libsdl2-2.0-0</source>
        <translation>installieren Sie die neueste libSDL2-2.0.so.0: unter Debian und Ubuntu das Paket libsdl2-2.0-0</translation>
    </message>
    <message>
        <source>use --rumble</source>
        <translation>verwenden Sie --rumble</translation>
    </message>
    <message>
        <source>is for game controllers</source>
        <translation>ist für Gamecontroller</translation>
    </message>
    <message>
        <source>the trace of attempt %1 was not kept: its result and scores alone are stored</source>
        <translation>die Aufzeichnung von Versuch %1 wurde nicht behalten: nur Ergebnis und Wertungen sind gespeichert</translation>
    </message>
    <message>
        <source>choose an attempt whose trace was kept</source>
        <translation>wählen Sie einen Versuch, dessen Aufzeichnung behalten wurde</translation>
    </message>
    <message>
        <source>is not the demonstration that this program was delivered with</source>
        <translation>ist nicht die Vorführung, mit der dieses Programm ausgeliefert wurde</translation>
    </message>
    <message>
        <source>install the program again</source>
        <translation>installieren Sie das Programm neu</translation>
    </message>
    <message>
        <source>The connection to the tracker&apos;s server ended. Start the server again and check the network.</source>
        <translation>Die Verbindung zum Server des Trackers ist beendet. Starten Sie den Server neu und prüfen Sie das Netzwerk.</translation>
    </message>
    <message>
        <source>What the tracker&apos;s server sends is not OpenIGTLink. Check its port.</source>
        <translation>Was der Server des Trackers sendet, ist kein OpenIGTLink. Prüfen Sie seinen Port.</translation>
    </message>
    <message>
        <source>Messages of the tracker&apos;s server have wrong checksums and are not used. Install the newest version of the program that sends them.</source>
        <translation>Nachrichten des Tracker-Servers haben falsche Prüfsummen und werden nicht verwendet. Installieren Sie die neueste Version des Programms, das sie sendet.</translation>
    </message>
    <message>
        <source>The tracker sends no pose of an instrument. Bring the instrument into its view, and check that the tracker is running.</source>
        <translation>Der Tracker sendet von einem Instrument keine Lage. Bringen Sie das Instrument in sein Sichtfeld und prüfen Sie, ob der Tracker läuft.</translation>
    </message>
    <message>
        <source>spacenavd, which reads the SpaceMouse, ended or sends something else. Start it again: `sudo systemctl restart spacenavd`.</source>
        <translation>spacenavd, das die SpaceMouse liest, hat sich beendet oder sendet etwas anderes. Starten Sie es neu: `sudo systemctl restart spacenavd`.</translation>
    </message>
    <message>
        <source>use openigtlink:HOST:PORT, then left=NAME, right=NAME, scope=NAME, length=MM, shaft=+z or axes=+x+y+z, each after a comma</source>
        <translation>verwenden Sie openigtlink:HOST:PORT, danach left=NAME, right=NAME, scope=NAME, length=MM, shaft=+z oder axes=+x+y+z, jeweils nach einem Komma</translation>
    </message>
    <message>
        <source>%1 is not a right-handed frame</source>
        <translation>%1 ist kein rechtshändiges Koordinatensystem</translation>
    </message>
    <message>
        <source>name the axis of the tracker that points to the right, the one that points up and the one towards the person</source>
        <translation>nennen Sie die Achse des Trackers, die nach rechts zeigt, die nach oben und die zur Person hin</translation>
    </message>
    <message>
        <source>what it sends is not OpenIGTLink</source>
        <translation>was dort gesendet wird, ist kein OpenIGTLink</translation>
    </message>
    <message>
        <source>check that this is the port of the OpenIGTLink server</source>
        <translation>prüfen Sie, ob dies der Port des OpenIGTLink-Servers ist</translation>
    </message>
    <message>
        <source>the server closed the connection</source>
        <translation>der Server hat die Verbindung geschlossen</translation>
    </message>
    <message>
        <source>end other programs that are connected to it, or restart it</source>
        <translation>beenden Sie andere Programme, die mit ihm verbunden sind, oder starten Sie ihn neu</translation>
    </message>
    <message>
        <source>its messages have wrong checksums</source>
        <translation>seine Nachrichten haben falsche Prüfsummen</translation>
    </message>
    <message>
        <source>install the newest version of the program that sends</source>
        <translation>installieren Sie die neueste Version des Programms, das sendet</translation>
    </message>
    <message>
        <source>calibrate the tracker, and send a rotation and a place in millimetres</source>
        <translation>kalibrieren Sie den Tracker, und senden Sie eine Drehung und einen Ort in Millimetern</translation>
    </message>
    <message>
        <source>sent no pose of %1</source>
        <translation>hat keine Lage von %1 gesendet</translation>
    </message>
    <message>
        <source>start tracking there, with the tools in its view</source>
        <translation>starten Sie dort die Verfolgung, mit den Werkzeugen im Sichtfeld</translation>
    </message>
    <message>
        <source>sent no pose of %1, only of %2</source>
        <translation>hat keine Lage von %1 gesendet, nur von %2</translation>
    </message>
    <message>
        <source>name its tools: openigtlink:%1,left=NAME,right=NAME</source>
        <translation>nennen Sie seine Werkzeuge: openigtlink:%1,left=NAME,right=NAME</translation>
    </message>
    <message>
        <source>use space-mouse, space-mouse:left or space-mouse:right</source>
        <translation>verwenden Sie space-mouse, space-mouse:left oder space-mouse:right</translation>
    </message>
    <message>
        <source>spacenavd, which reads the SpaceMouse, does not answer: %1</source>
        <translation>spacenavd, das die SpaceMouse liest, antwortet nicht: %1</translation>
    </message>
    <message>
        <source>install it (package spacenavd) and start it with `sudo systemctl restart spacenavd`; SPNAV_SOCKET names another socket</source>
        <translation>installieren Sie es (Paket spacenavd) und starten Sie es mit `sudo systemctl restart spacenavd`; SPNAV_SOCKET nennt einen anderen Socket</translation>
    </message>
    <message>
        <source>no computer of this name: %1</source>
        <translation>kein Computer dieses Namens: %1</translation>
    </message>
    <message>
        <source>check the name, or give the number of its address</source>
        <translation>prüfen Sie den Namen, oder geben Sie die Adresse als Zahl an</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not HOST:PORT</source>
        <translation>„%1“ ist nicht HOST:PORT</translation>
    </message>
    <message>
        <source>such as 127.0.0.1:18944 or [::1]:18944</source>
        <translation>zum Beispiel 127.0.0.1:18944 oder [::1]:18944</translation>
    </message>
    <message>
        <source>no OpenIGTLink server answers: %1</source>
        <translation>kein OpenIGTLink-Server antwortet: %1</translation>
    </message>
    <message>
        <source>start the server (in PLUS, 3D Slicer or the tracker&apos;s own program), and check its address, its port and the firewall</source>
        <translation>starten Sie den Server (in PLUS, 3D Slicer oder im Programm des Trackers), und prüfen Sie Adresse, Port und Firewall</translation>
    </message>
    <message>
        <source>cannot be served: %1</source>
        <translation>kann nicht bedient werden: %1</translation>
    </message>
    <message>
        <source>end the other program that uses this port (3D Slicer and PLUS use 18944 as well), or choose another port or an address of this computer</source>
        <translation>beenden Sie das andere Programm, das diesen Port benutzt (auch 3D Slicer und PLUS benutzen 18944), oder wählen Sie einen anderen Port oder eine Adresse dieses Computers</translation>
    </message>
    <message>
        <source>start sending there, then record again</source>
        <translation>starten Sie dort das Senden, und nehmen Sie dann noch einmal auf</translation>
    </message>
    <message>
        <source>name its tools with --left, --right and --camera</source>
        <translation>nennen Sie seine Werkzeuge mit --left, --right und --camera</translation>
    </message>
    <message>
        <source>name the file of the trace: -o TRACE.csv</source>
        <translation>nennen Sie die Datei der Aufzeichnung: -o AUFZEICHNUNG.csv</translation>
    </message>
    <message>
        <source>is the file of the trace</source>
        <translation>ist die Datei der Aufzeichnung</translation>
    </message>
    <message>
        <source>name another file</source>
        <translation>nennen Sie eine andere Datei</translation>
    </message>
    <message>
        <source>The tracker sends poses that cannot be used. Bring the instrument into its view, and calibrate it where that does not help.</source>
        <translation>Der Tracker sendet Lagen, die nicht brauchbar sind. Bringen Sie das Instrument in sein Sichtfeld; hilft das nicht, kalibrieren Sie ihn.</translation>
    </message>
    <message>
        <source>it sends poses that cannot be used</source>
        <translation>er sendet Lagen, die nicht brauchbar sind</translation>
    </message>
    <message>
        <source>%1 is merged into another account</source>
        <translation>%1 ist mit einem anderen Konto zusammengeführt</translation>
    </message>
    <message>
        <source>change the account that stays, or undo the merge first (`fulcrum people unmerge`)</source>
        <translation>ändern Sie das Konto, das bleibt, oder machen Sie das Zusammenführen zuerst rückgängig (`fulcrum people unmerge`)</translation>
    </message>
    <message>
        <source>forms of raters about them</source>
        <translation>Bewertungsbögen dazu</translation>
    </message>
    <message>
        <source>comments on them</source>
        <translation>Kommentare dazu</translation>
    </message>
    <message>
        <source>personal goals</source>
        <translation>persönliche Ziele</translation>
    </message>
    <message>
        <source>comments written, drafts included</source>
        <translation>selbst geschriebene Kommentare, auch Entwürfe</translation>
    </message>
    <message>
        <source>forms filled in, drafts included</source>
        <translation>selbst ausgefüllte Bögen, auch Entwürfe</translation>
    </message>
    <message>
        <source>people merged earlier</source>
        <translation>früher zusammengeführte Personen</translation>
    </message>
    <message>
        <source>decisions and forms of one account about the other, which then do not count</source>
        <translation>Entscheidungen und Bögen des einen Kontos über das andere, die dann nicht zählen</translation>
    </message>
    <message>
        <source>this is one account, not two</source>
        <translation>das ist ein Konto, nicht zwei</translation>
    </message>
    <message>
        <source>name the doubled account, then the one that stays</source>
        <translation>nennen Sie das doppelte Konto, dann das, das bleibt</translation>
    </message>
    <message>
        <source>only real people are merged</source>
        <translation>nur echte Personen werden zusammengeführt</translation>
    </message>
    <message>
        <source>simulated people are never part of the results</source>
        <translation>simulierte Personen gehören nie zu den Ergebnissen</translation>
    </message>
    <message>
        <source>nobody merges an account of their own</source>
        <translation>niemand führt ein eigenes Konto zusammen</translation>
    </message>
    <message>
        <source>%1 is merged into another account already</source>
        <translation>%1 ist schon mit einem anderen Konto zusammengeführt</translation>
    </message>
    <message>
        <source>undo that merge first (`fulcrum people unmerge`)</source>
        <translation>machen Sie dieses Zusammenführen zuerst rückgängig (`fulcrum people unmerge`)</translation>
    </message>
    <message>
        <source>name the account that stays</source>
        <translation>nennen Sie das Konto, das bleibt</translation>
    </message>
    <message>
        <source>%1 is deactivated</source>
        <translation>%1 ist deaktiviert</translation>
    </message>
    <message>
        <source>activate the account that stays, or merge the other way round</source>
        <translation>aktivieren Sie das Konto, das bleibt, oder führen Sie in der anderen Richtung zusammen</translation>
    </message>
    <message>
        <source>%1 holds a role that %2 does not: %3</source>
        <translation>%1 hat eine Rolle, die %2 nicht hat: %3</translation>
    </message>
    <message>
        <source>a merge grants nothing: give that role to the account that stays, or take it from the other one, first</source>
        <translation>Zusammenführen vergibt keine Rollen: geben Sie die Rolle zuerst dem Konto, das bleibt, oder nehmen Sie sie dem anderen</translation>
    </message>
    <message>
        <source>the doubled account performs an attempt now</source>
        <translation>mit dem doppelten Konto läuft gerade ein Versuch</translation>
    </message>
    <message>
        <source>wait until it has ended</source>
        <translation>warten Sie, bis er beendet ist</translation>
    </message>
    <message>
        <source>%1 is not merged into another account</source>
        <translation>%1 ist mit keinem anderen Konto zusammengeführt</translation>
    </message>
    <message>
        <source>name an account that was merged</source>
        <translation>nennen Sie ein zusammengeführtes Konto</translation>
    </message>
    <message>
        <source>no task was performed by %1 people or more</source>
        <translation>keine Aufgabe wurde von mindestens %1 Personen ausgeführt</translation>
    </message>
    <message>
        <source>fewer could be recognised; export when there are more</source>
        <translation>weniger ließen sich erkennen; exportieren Sie, wenn es mehr sind</translation>
    </message>
    <message>
        <source>no schedule %1</source>
        <translation>keine Planung %1</translation>
    </message>
    <message>
        <source>list the schedules and name one of them</source>
        <translation>zeigen Sie die Planungen an und nennen Sie eine davon</translation>
    </message>
    <message>
        <source>%1: the folder of a schedule is a path from /</source>
        <translation>%1: der Ordner einer Planung ist ein Pfad ab /</translation>
    </message>
    <message>
        <source>a timer starts in another folder than you; give the whole path</source>
        <translation>ein Zeitgeber startet in einem anderen Ordner als Sie; geben Sie den ganzen Pfad an</translation>
    </message>
    <message>
        <source>the same report is scheduled already</source>
        <translation>derselbe Bericht ist schon geplant</translation>
    </message>
    <message>
        <source>list the schedules</source>
        <translation>zeigen Sie die Planungen an</translation>
    </message>
    <message>
        <source>say why: it is stored in the audit log</source>
        <translation>sagen Sie, warum: es wird im Protokoll gespeichert</translation>
    </message>
    <message>
        <source>name the folder to write to: -o FOLDER</source>
        <translation>nennen Sie den Zielordner: -o ORDNER</translation>
    </message>
    <message>
        <source>see `fulcrum schedule add --help`</source>
        <translation>siehe `fulcrum schedule add --help`</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not the name of an exercise</source>
        <translation>„%1“ ist kein Name einer Übung</translation>
    </message>
    <message>
        <source>use 1 to %1 letters, digits, dots, hyphens and underscores: peg-transfer</source>
        <translation>verwenden Sie 1 bis %1 Buchstaben (ohne Umlaute), Ziffern, Punkte, Bindestriche und Unterstriche: peg-transfer</translation>
    </message>
    <message>
        <source>what recorded the trace is not named, or its name is too long</source>
        <translation>womit aufgezeichnet wurde, ist nicht genannt, oder der Name ist zu lang</translation>
    </message>
    <message>
        <source>give a name of 1 to %1 characters</source>
        <translation>geben Sie einen Namen mit 1 bis %1 Zeichen an</translation>
    </message>
    <message>
        <source>the attempt is dated in the future, or before 1970</source>
        <translation>der Versuch liegt laut Datum in der Zukunft oder vor 1970</translation>
    </message>
    <message>
        <source>give the date and time at which it was performed</source>
        <translation>geben Sie an, an welchem Tag und zu welcher Zeit er durchgeführt wurde</translation>
    </message>
    <message>
        <source>the trace has no samples or no duration</source>
        <translation>die Aufzeichnung hat keine Messwerte oder keine Dauer</translation>
    </message>
    <message>
        <source>import a trace that fulcrum metrics reads</source>
        <translation>importieren Sie eine Aufzeichnung, die fulcrum metrics liest</translation>
    </message>
    <message>
        <source>the trace has more than 256 MiB as text</source>
        <translation>die Aufzeichnung hat als Text mehr als 256 MiB</translation>
    </message>
    <message>
        <source>import a part of it, or fewer columns</source>
        <translation>importieren Sie einen Teil davon oder weniger Spalten</translation>
    </message>
    <message>
        <source>an external attempt is measured, never judged</source>
        <translation>ein externer Versuch wird gemessen, nie bewertet</translation>
    </message>
    <message>
        <source>store its metrics alone</source>
        <translation>speichern Sie nur seine Kennzahlen</translation>
    </message>
    <message>
        <source>this trace was imported for this person already: attempt %1</source>
        <translation>diese Aufzeichnung wurde für diese Person schon importiert: Versuch %1</translation>
    </message>
    <message>
        <source>void that attempt first if it is to be imported again</source>
        <translation>erklären Sie erst jenen Versuch für ungültig, wenn sie noch einmal importiert werden soll</translation>
    </message>
    <message>
        <source>the trace has more than 64 MiB when it is compressed</source>
        <translation>die Aufzeichnung hat komprimiert mehr als 64 MiB</translation>
    </message>
    <message>
        <source>there is no imported trace of attempt %1 in this store</source>
        <translation>in diesem Speicher gibt es keine importierte Aufzeichnung von Versuch %1</translation>
    </message>
    <message>
        <source>open it at the station that imported it</source>
        <translation>öffnen Sie ihn an der Station, die ihn importiert hat</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a date and time</source>
        <translation>„%1“ ist kein Datum mit Uhrzeit</translation>
    </message>
    <message>
        <source>give it as 2026-11-20T14:05</source>
        <translation>geben Sie es in der Form 2026-11-20T14:05 an</translation>
    </message>
    <message>
        <source>name the exercise and the person who performed it</source>
        <translation>nennen Sie die Übung und die Person, die sie durchgeführt hat</translation>
    </message>
    <message>
        <source>&lt;%1&gt; has no attribute %2</source>
        <translation>&lt;%1&gt; hat kein Attribut %2</translation>
    </message>
    <message>
        <source>record it again with PerkTutor, or remove this element</source>
        <translation>nehmen Sie es mit PerkTutor neu auf, oder entfernen Sie dieses Element</translation>
    </message>
    <message>
        <source>the file ends within an element</source>
        <translation>die Datei endet mitten in einem Element</translation>
    </message>
    <message>
        <source>the recording was cut off: copy the file again</source>
        <translation>die Aufzeichnung ist abgeschnitten: kopieren Sie die Datei noch einmal</translation>
    </message>
    <message>
        <source>the attributes of &lt;%1&gt; cannot be read</source>
        <translation>die Attribute von &lt;%1&gt; sind nicht lesbar</translation>
    </message>
    <message>
        <source>choose a recording that PerkTutor stored as XML</source>
        <translation>wählen Sie eine Aufzeichnung, die PerkTutor als XML gespeichert hat</translation>
    </message>
    <message>
        <source>attribute %1 has more than %2 bytes</source>
        <translation>Attribut %1 hat mehr als %2 Bytes</translation>
    </message>
    <message>
        <source>poses have a time already</source>
        <translation>Posen haben schon eine Zeit</translation>
    </message>
    <message>
        <source>does not name a device and an entry of its pose</source>
        <translation>nennt kein Gerät mit einem Eintrag seiner Pose</translation>
    </message>
    <message>
        <source>write DEVICE.x, .y or .z, or for an axis DEVICE.z_axis.x</source>
        <translation>schreiben Sie GERÄT.x, .y oder .z, oder für eine Achse GERÄT.z_axis.x</translation>
    </message>
    <message>
        <source>has no meaning for a recording of poses</source>
        <translation>hat bei einer Aufzeichnung von Posen keine Bedeutung</translation>
    </message>
    <message>
        <source>%1 is not a number: &quot;%2&quot;</source>
        <translation>%1 ist keine Zahl: „%2“</translation>
    </message>
    <message>
        <source>remove this element, or record again</source>
        <translation>entfernen Sie dieses Element, oder nehmen Sie neu auf</translation>
    </message>
    <message>
        <source>the time is out of range</source>
        <translation>die Zeit liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>transform has not 16 numbers by rows, the last four of them 0 0 0 1 (numbers: %1)</source>
        <translation>transform hat nicht 16 Zahlen zeilenweise, die letzten vier davon 0 0 0 1 (Zahlen: %1)</translation>
    </message>
    <message>
        <source>choose a recording of rigid tools that PerkTutor stored as XML</source>
        <translation>wählen Sie eine Aufzeichnung starrer Werkzeuge, die PerkTutor als XML gespeichert hat</translation>
    </message>
    <message>
        <source>more than %1 devices</source>
        <translation>mehr als %1 Geräte</translation>
    </message>
    <message>
        <source>does not begin with &lt;TransformRecorderLog&gt;</source>
        <translation>beginnt nicht mit &lt;TransformRecorderLog&gt;</translation>
    </message>
    <message>
        <source>DeviceName is empty, too long or not UTF-8</source>
        <translation>DeviceName ist leer, zu lang oder kein UTF-8</translation>
    </message>
    <message>
        <source>name the device in 3D Slicer and record again</source>
        <translation>benennen Sie das Gerät in 3D Slicer und nehmen Sie neu auf</translation>
    </message>
    <message>
        <source>the file ends without &lt;/TransformRecorderLog&gt;</source>
        <translation>die Datei endet ohne &lt;/TransformRecorderLog&gt;</translation>
    </message>
    <message>
        <source>there is no pose of the device %1</source>
        <translation>es gibt keine Pose des Geräts %1</translation>
    </message>
    <message>
        <source>name one of these in the mapping: %1</source>
        <translation>nennen Sie eines davon in der Zuordnung: %1</translation>
    </message>
    <message>
        <source>The Inverse service of Haply ended or closed the connection. Start it again, and end other programs that use the device.</source>
        <translation>Der Inverse-Dienst von Haply hat sich beendet oder die Verbindung geschlossen. Starten Sie ihn neu, und beenden Sie andere Programme, die das Gerät verwenden.</translation>
    </message>
    <message>
        <source>The Inverse service of Haply does not answer. Restart it, and check the cable of the device.</source>
        <translation>Der Inverse-Dienst von Haply antwortet nicht. Starten Sie ihn neu, und prüfen Sie das Kabel des Geräts.</translation>
    </message>
    <message>
        <source>The Inverse service of Haply sends readings that cannot be used. Restart it, and install its newest version.</source>
        <translation>Der Inverse-Dienst von Haply sendet Messwerte, die nicht zu gebrauchen sind. Starten Sie ihn neu, und installieren Sie seine neueste Version.</translation>
    </message>
    <message>
        <source>The device has no power supply, so it renders no force. Connect its power supply.</source>
        <translation>Das Gerät hat kein Netzteil und gibt daher keine Kraft. Schließen Sie sein Netzteil an.</translation>
    </message>
    <message>
        <source>libwebsockets, which speaks with it, does not start</source>
        <translation>libwebsockets, das mit ihm spricht, startet nicht</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not the name of a kind of device</source>
        <translation>„%1“ ist nicht der Name einer Art von Gerät</translation>
    </message>
    <message>
        <source>write haply:PORT, then left=ID, right=ID, events=PORT, grip=+z or axes=+x+z-y, each after a comma</source>
        <translation>schreiben Sie haply:PORT, dann left=ID, right=ID, events=PORT, grip=+z oder axes=+x+z-y, jeweils nach einem Komma</translation>
    </message>
    <message>
        <source>the Inverse service of Haply does not answer: %1</source>
        <translation>der Inverse-Dienst von Haply antwortet nicht: %1</translation>
    </message>
    <message>
        <source>install the service from Haply and start it on this computer; haply:PORT names another port</source>
        <translation>installieren Sie den Dienst von Haply und starten Sie ihn auf diesem Computer; haply:PORT nennt einen anderen Port</translation>
    </message>
    <message>
        <source>what answers there is not the Inverse service of Haply</source>
        <translation>was dort antwortet, ist nicht der Inverse-Dienst von Haply</translation>
    </message>
    <message>
        <source>end the program that listens at this port, or name the port of the service: haply:PORT</source>
        <translation>beenden Sie das Programm, das diesen Port belegt, oder nennen Sie den Port des Dienstes: haply:PORT</translation>
    </message>
    <message>
        <source>the Inverse service of Haply sends nothing</source>
        <translation>der Inverse-Dienst von Haply sendet nichts</translation>
    </message>
    <message>
        <source>the service closed the connection</source>
        <translation>der Dienst hat die Verbindung geschlossen</translation>
    </message>
    <message>
        <source>restart the Inverse service, and end other programs that use it</source>
        <translation>starten Sie den Inverse-Dienst neu, und beenden Sie andere Programme, die ihn verwenden</translation>
    </message>
    <message>
        <source>what it sends is not what the Inverse service of Haply sends from version 3.1 on</source>
        <translation>was er sendet, ist nicht, was der Inverse-Dienst von Haply ab Version 3.1 sendet</translation>
    </message>
    <message>
        <source>install the newest version of the Inverse service</source>
        <translation>installieren Sie die neueste Version des Inverse-Dienstes</translation>
    </message>
    <message>
        <source>the Inverse service of Haply reports no Inverse3</source>
        <translation>der Inverse-Dienst von Haply meldet keinen Inverse3</translation>
    </message>
    <message>
        <source>connect the device and its power supply, and wait until the service shows it</source>
        <translation>schließen Sie das Gerät und sein Netzteil an, und warten Sie, bis der Dienst es anzeigt</translation>
    </message>
    <message>
        <source>no Inverse3 with the identity %1 is connected, only %2</source>
        <translation>kein Inverse3 mit der Kennung %1 ist angeschlossen, nur %2</translation>
    </message>
    <message>
        <source>connect it, or name another: haply:left=ID,right=ID</source>
        <translation>schließen Sie ihn an, oder nennen Sie einen anderen: haply:left=ID,right=ID</translation>
    </message>
    <message>
        <source>the Inverse3 %1 is in use by another program</source>
        <translation>der Inverse3 %1 wird von einem anderen Programm verwendet</translation>
    </message>
    <message>
        <source>end the other program that uses it; where there is none, restart the Inverse service</source>
        <translation>beenden Sie das andere Programm, das ihn verwendet; wo es keines gibt, starten Sie den Inverse-Dienst neu</translation>
    </message>
    <message>
        <source>the Inverse service of Haply sends no position that can be used</source>
        <translation>der Inverse-Dienst von Haply sendet keine Position, die zu gebrauchen ist</translation>
    </message>
    <message>
        <source>restart the service, and install its newest version</source>
        <translation>starten Sie den Dienst neu, und installieren Sie seine neueste Version</translation>
    </message>
    <message>
        <source>install the package libwebsockets17 again</source>
        <translation>installieren Sie das Paket libwebsockets17 neu</translation>
    </message>
    <message>
        <source>%1: signed by the key %2, but the key %3 was announced</source>
        <translation>%1: vom Schlüssel %2 unterschrieben, angekündigt war aber der Schlüssel %3</translation>
    </message>
    <message>
        <source>%1: signed by the key %2, which ended with row %3</source>
        <translation>%1: vom Schlüssel %2 unterschrieben, der mit Zeile %3 endete</translation>
    </message>
    <message>
        <source>%1: from here on the key %2 signs, which the key before, %3, did not announce (its file was lost, or somebody else wrote this)</source>
        <translation>%1: von hier an unterschreibt der Schlüssel %2, den der vorige, %3, nicht angekündigt hat (seine Datei ging verloren, oder jemand anderes hat dies geschrieben)</translation>
    </message>
    <message>
        <source>%1: does not announce a new key</source>
        <translation>%1: kündigt keinen neuen Schlüssel an</translation>
    </message>
    <message>
        <source>a new key needs a reason</source>
        <translation>ein neuer Schlüssel braucht einen Grund</translation>
    </message>
    <message>
        <source>say why: planned, or what may have been copied</source>
        <translation>sagen Sie, warum: geplant, oder was kopiert worden sein kann</translation>
    </message>
    <message>
        <source>a person who is to be erased is performing at this station</source>
        <translation>eine Person, die gelöscht werden soll, übt gerade an diesem Arbeitsplatz</translation>
    </message>
    <message>
        <source>try again when the attempt has ended</source>
        <translation>versuchen Sie es noch einmal, wenn der Versuch beendet ist</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was merged into a person who was erased on the server, which did not know of the merge: erase %2 there too (`fulcrum server erase`), or undo the merge</source>
        <translation>„%1“ wurde mit einer Person zusammengeführt, die auf dem Server gelöscht wurde, der davon nichts wusste: Löschen Sie dort auch %2 (`fulcrum server erase`), oder machen Sie die Zusammenführung rückgängig</translation>
    </message>
    <message>
        <source>%1: the list of erased people: %2</source>
        <translation>%1: die Liste der gelöschten Personen: %2</translation>
    </message>
    <message>
        <source>put its copy back, or make its folder writable; nothing was erased</source>
        <translation>legen Sie die Kopie zurück, oder machen Sie den Ordner beschreibbar; es wurde nichts gelöscht</translation>
    </message>
    <message>
        <source>is not such a list</source>
        <translation>ist keine solche Liste</translation>
    </message>
    <message>
        <source>is damaged</source>
        <translation>ist beschädigt</translation>
    </message>
    <message>
        <source>nobody is erased in the demonstration</source>
        <translation>in der Demonstration wird niemand gelöscht</translation>
    </message>
    <message>
        <source>this programme has a server, which would bring the person back</source>
        <translation>dieses Programm hat einen Server, der die Person zurückbringen würde</translation>
    </message>
    <message>
        <source>erase on the server (`fulcrum server erase`); each station follows at its next sync</source>
        <translation>löschen Sie auf dem Server (`fulcrum server erase`); jeder Arbeitsplatz folgt bei seinem nächsten Abgleich</translation>
    </message>
    <message>
        <source>the last administrator cannot be erased</source>
        <translation>der letzte Administrator kann nicht gelöscht werden</translation>
    </message>
    <message>
        <source>give another person the role first</source>
        <translation>geben Sie zuerst einer anderen Person die Rolle</translation>
    </message>
    <message>
        <source>an erasure needs a reason</source>
        <translation>eine Löschung braucht einen Grund</translation>
    </message>
    <message>
        <source>say who asked for it; the reason itself stays, so name nobody in it</source>
        <translation>sagen Sie, wer darum gebeten hat; der Grund selbst bleibt, nennen Sie darin also keine Namen</translation>
    </message>
    <message>
        <source>the newest audit row is signed by the key %1, to which no announced keys lead from %2: the log was written by somebody else, or the key was lost</source>
        <translation>die neueste Zeile des Protokolls ist vom Schlüssel %1 unterschrieben, zu dem von %2 keine angekündigten Schlüssel führen: Das Protokoll hat jemand anderes geschrieben, oder der Schlüssel ging verloren</translation>
    </message>
    <message>
        <source>unset DISPLAY and WAYLAND_DISPLAY to draw without one</source>
        <translation>löschen Sie DISPLAY und WAYLAND_DISPLAY, um ohne Bildschirm zu zeichnen</translation>
    </message>
    <message>
        <source>no display can be opened</source>
        <translation>es lässt sich kein Bildschirm öffnen</translation>
    </message>
    <message>
        <source>no display can be opened (%1)</source>
        <translation>es lässt sich kein Bildschirm öffnen (%1)</translation>
    </message>
    <message>
        <source>start fulcrum on a desktop, or use its commands, which need no display (fulcrum --help lists them)</source>
        <translation>starten Sie fulcrum auf einer grafischen Oberfläche, oder verwenden Sie seine Befehle, die keinen Bildschirm brauchen (fulcrum --help nennt sie)</translation>
    </message>
    <message>
        <source>needs a window: mice and keys are read there</source>
        <translation>braucht ein Fenster: Mäuse und Tasten werden dort gelesen</translation>
    </message>
    <message>
        <source>start fulcrum and try it on the page Settings</source>
        <translation>starten Sie fulcrum und probieren Sie es auf der Seite Einstellungen</translation>
    </message>
    <message>
        <source>names no script</source>
        <translation>nennt kein Skript</translation>
    </message>
    <message>
        <source>write --test virtual:SCRIPT.json</source>
        <translation>schreiben Sie --test virtual:SKRIPT.json</translation>
    </message>
    <message>
        <source>is not the name of a kind of device</source>
        <translation>ist nicht der Name einer Art von Gerät</translation>
    </message>
    <message>
        <source>write it in small letters: --test %1</source>
        <translation>schreiben Sie es in Kleinbuchstaben: --test %1</translation>
    </message>
    <message>
        <source>use one of %1; `fulcrum devices` lists what is connected</source>
        <translation>verwenden Sie eines von %1; `fulcrum devices` listet auf, was angeschlossen ist</translation>
    </message>
    <message>
        <source>the title is missing or too long</source>
        <translation>der Titel fehlt oder ist zu lang</translation>
    </message>
    <message>
        <source>give a title of 1 to 120 characters</source>
        <translation>geben Sie einen Titel von 1 bis 120 Zeichen an</translation>
    </message>
    <message>
        <source>the curriculum has no task</source>
        <translation>das Curriculum hat keine Aufgabe</translation>
    </message>
    <message>
        <source>add one</source>
        <translation>fügen Sie eine hinzu</translation>
    </message>
    <message>
        <source>the curriculum has no stage</source>
        <translation>das Curriculum hat keine Stufe</translation>
    </message>
    <message>
        <source>the curriculum is too large</source>
        <translation>das Curriculum ist zu groß</translation>
    </message>
    <message>
        <source>keep it to 12 stages and 60 tasks</source>
        <translation>höchstens 12 Stufen und 60 Aufgaben sind möglich</translation>
    </message>
    <message>
        <source>the stage has no short name, or a long one</source>
        <translation>die Stufe hat keinen oder einen zu langen Kurznamen</translation>
    </message>
    <message>
        <source>give a short name of 1 to 8 characters, such as A</source>
        <translation>geben Sie einen Kurznamen von 1 bis 8 Zeichen an, zum Beispiel A</translation>
    </message>
    <message>
        <source>the title of stage %1 is missing or too long</source>
        <translation>der Titel der Stufe %1 fehlt oder ist zu lang</translation>
    </message>
    <message>
        <source>give a title of 1 to 60 characters</source>
        <translation>geben Sie einen Titel von 1 bis 60 Zeichen an</translation>
    </message>
    <message>
        <source>stage %1 has no task</source>
        <translation>die Stufe %1 hat keine Aufgabe</translation>
    </message>
    <message>
        <source>move a task to it, or remove it</source>
        <translation>ordnen Sie ihr eine Aufgabe zu oder entfernen Sie sie</translation>
    </message>
    <message>
        <source>remove it, or have its file installed first</source>
        <translation>entfernen Sie sie oder lassen Sie zuerst ihre Datei installieren</translation>
    </message>
    <message>
        <source>choose one of the stages, or add it</source>
        <translation>wählen Sie eine der Stufen oder fügen Sie sie hinzu</translation>
    </message>
    <message>
        <source>asks for passes on %1 variants, but %2 has %3</source>
        <translation>verlangt Bestehen an %1 Varianten, aber %2 hat %3</translation>
    </message>
    <message>
        <source>ask for fewer, or the rule is never met</source>
        <translation>verlangen Sie weniger, sonst wird die Regel nie erfüllt</translation>
    </message>
    <message>
        <source>nobody can meet the rule: it counts one attempt, and asks for passes on two days</source>
        <translation>niemand kann die Regel erfüllen: Sie zählt einen Versuch und verlangt Bestehen an zwei Tagen</translation>
    </message>
    <message>
        <source>nobody can meet the rule: it counts %1 attempts, and asks for passes on %2 variants</source>
        <translation>niemand kann die Regel erfüllen: Sie zählt %1 Versuche und verlangt Bestehen an %2 Varianten</translation>
    </message>
    <message>
        <source>let it count at least %1 attempts, or use LC-CUSUM</source>
        <translation>lassen Sie sie mindestens %1 Versuche zählen oder verwenden Sie LC-CUSUM</translation>
    </message>
    <message>
        <source>add it, or take it out of the prerequisites</source>
        <translation>fügen Sie sie hinzu oder streichen Sie sie aus den Voraussetzungen</translation>
    </message>
    <message>
        <source>no class of devices is chosen</source>
        <translation>es ist keine Geräteklasse gewählt</translation>
    </message>
    <message>
        <source>choose at least one, or no attempt counts</source>
        <translation>wählen Sie mindestens eine, sonst zählt kein Versuch</translation>
    </message>
    <message>
        <source>%1 has no benchmark for the class of devices %2</source>
        <translation>für %1 gibt es keinen Benchmark mit der Geräteklasse %2</translation>
    </message>
    <message>
        <source>gates based on the experts&apos; range are not judged with it until a set is installed</source>
        <translation>Kriterien nach dem Bereich der Experten werden damit nicht beurteilt, bis ein Satz installiert ist</translation>
    </message>
    <message>
        <source>another version was published in the meantime: %1</source>
        <translation>inzwischen wurde eine andere Version veröffentlicht: %1</translation>
    </message>
    <message>
        <source>%1: cannot be written (%2)</source>
        <translation>%1: kann nicht geschrieben werden (%2)</translation>
    </message>
    <message>
        <source>save the draft; the administrator puts the file there, and an educator accepts it with `fulcrum assets accept`</source>
        <translation>speichern Sie den Entwurf; die Administration legt die Datei dort ab, und eine Lehrperson nimmt sie mit `fulcrum assets accept` an</translation>
    </message>
    <message>
        <source>make the store&apos;s folder writable and free some space on the disk</source>
        <translation>machen Sie den Ordner des Datenspeichers beschreibbar und schaffen Sie Platz auf der Festplatte</translation>
    </message>
    <message>
        <source>is another curriculum: %1</source>
        <translation>ist ein anderes Curriculum: %1</translation>
    </message>
    <message>
        <source>open a draft of %1</source>
        <translation>öffnen Sie einen Entwurf von %1</translation>
    </message>
    <message>
        <source>has both %1 and %2</source>
        <translation>hat %1 und %2 zugleich</translation>
    </message>
    <message>
        <source>something is missing in the remedy</source>
        <translation>der Abhilfe fehlt etwas</translation>
    </message>
    <message>
        <source>give one bound, &quot;above&quot; or &quot;below&quot;</source>
        <translation>geben Sie eine Grenze an, &quot;above&quot; oder &quot;below&quot;</translation>
    </message>
    <message>
        <source>say what to do: one of &quot;practise_from&quot;, &quot;task&quot; (with &quot;variant&quot; or without), &quot;variant&quot;, &quot;feedback&quot;</source>
        <translation>sagen Sie, was zu tun ist: eines von &quot;practise_from&quot;, &quot;task&quot; (mit oder ohne &quot;variant&quot;), &quot;variant&quot;, &quot;feedback&quot;</translation>
    </message>
    <message>
        <source>the task has too many remedies</source>
        <translation>die Aufgabe hat zu viele Abhilfen</translation>
    </message>
    <message>
        <source>keep %1 at most</source>
        <translation>behalten Sie höchstens %1</translation>
    </message>
    <message>
        <source>remedy %1: %2</source>
        <translation>Abhilfe %1: %2</translation>
    </message>
    <message>
        <source>did you mean %1? There are: %2</source>
        <translation>meinten Sie %1? Es gibt: %2</translation>
    </message>
    <message>
        <source>name the id of a metric that the task shows (docs/METRICS.md)</source>
        <translation>nennen Sie die Kennung einer Kennzahl, die die Aufgabe zeigt (docs/METRICS.md)</translation>
    </message>
    <message>
        <source>did you mean %1? docs/METRICS.md lists all metrics</source>
        <translation>meinten Sie %1? docs/METRICS.md nennt alle Kennzahlen</translation>
    </message>
    <message>
        <source>there is no metric %1</source>
        <translation>es gibt keine Kennzahl %1</translation>
    </message>
    <message>
        <source>%1 has no goal %2</source>
        <translation>%1 hat kein Ziel %2</translation>
    </message>
    <message>
        <source>%1 is the first goal of %2: from it on is the whole task</source>
        <translation>%1 ist das erste Ziel von %2: ab ihm ist es die ganze Aufgabe</translation>
    </message>
    <message>
        <source>name a later goal, or choose another remedy</source>
        <translation>nennen Sie ein späteres Ziel, oder wählen Sie eine andere Abhilfe</translation>
    </message>
    <message>
        <source>%1 is not a remedy for itself</source>
        <translation>%1 ist keine Abhilfe für sich selbst</translation>
    </message>
    <message>
        <source>name another task, or only a variant of this one</source>
        <translation>nennen Sie eine andere Aufgabe, oder nur eine Variante dieser</translation>
    </message>
    <message>
        <source>%1 has no variant %2</source>
        <translation>%1 hat keine Variante %2</translation>
    </message>
    <message>
        <source>%1 has no ghost: it is for the scope alone</source>
        <translation>%1 hat kein Schattenbild: Sie ist für die Kamera allein</translation>
    </message>
    <message>
        <source>write demonstration or replay</source>
        <translation>schreiben Sie demonstration oder replay</translation>
    </message>
    <message>
        <source>%1 is not measured in &apos;%2&apos;</source>
        <translation>%1 wird nicht in &apos;%2&apos; gemessen</translation>
    </message>
    <message>
        <source>write its unit, &quot;%1&quot;, and the bound in this unit</source>
        <translation>schreiben Sie ihre Einheit, &quot;%1&quot;, und die Grenze in dieser Einheit</translation>
    </message>
    <message>
        <source>the bound of %1 is on the good side</source>
        <translation>die Grenze von %1 liegt auf der guten Seite</translation>
    </message>
    <message>
        <source>a high value is good: write &quot;below&quot;</source>
        <translation>ein hoher Wert ist gut: schreiben Sie &quot;below&quot;</translation>
    </message>
    <message>
        <source>a low value is good: write &quot;above&quot;</source>
        <translation>ein niedriger Wert ist gut: schreiben Sie &quot;above&quot;</translation>
    </message>
    <message>
        <source>%1 does not show the metric %2</source>
        <translation>%1 zeigt die Kennzahl %2 nicht</translation>
    </message>
    <message>
        <source>name the ZIP archive or the folder with the OneRoster files</source>
        <translation>nennen Sie das ZIP-Archiv oder den Ordner mit den OneRoster-Dateien</translation>
    </message>
    <message>
        <source>is in the archive twice</source>
        <translation>ist zweimal im Archiv</translation>
    </message>
    <message>
        <source>pack every file once, all in the same folder</source>
        <translation>packen Sie jede Datei einmal, alle im selben Ordner</translation>
    </message>
    <message>
        <source>the archive is damaged or cut off</source>
        <translation>das Archiv ist beschädigt oder abgeschnitten</translation>
    </message>
    <message>
        <source>export it again, or unpack it and name the folder</source>
        <translation>exportieren Sie es noch einmal, oder entpacken Sie es und nennen Sie den Ordner</translation>
    </message>
    <message>
        <source>the archive is in several parts</source>
        <translation>das Archiv besteht aus mehreren Teilen</translation>
    </message>
    <message>
        <source>pack it in one file</source>
        <translation>packen Sie es in eine Datei</translation>
    </message>
    <message>
        <source>the archive has %1 files</source>
        <translation>das Archiv hat %1 Dateien</translation>
    </message>
    <message>
        <source>pack the OneRoster files alone</source>
        <translation>packen Sie nur die OneRoster-Dateien</translation>
    </message>
    <message>
        <source>is encrypted</source>
        <translation>ist verschlüsselt</translation>
    </message>
    <message>
        <source>pack it without a password</source>
        <translation>packen Sie sie ohne Passwort</translation>
    </message>
    <message>
        <source>is packed by another method (%1)</source>
        <translation>ist mit einem anderen Verfahren gepackt (%1)</translation>
    </message>
    <message>
        <source>pack it as an ordinary ZIP archive (deflate)</source>
        <translation>packen Sie sie als gewöhnliches ZIP-Archiv (deflate)</translation>
    </message>
    <message>
        <source>is larger than 64 MiB</source>
        <translation>ist größer als 64 MiB</translation>
    </message>
    <message>
        <source>name the version: --to rectal@3</source>
        <translation>nennen Sie die Version: --to rectal@3</translation>
    </message>
    <message>
        <source>The trainer was unplugged. Plug it in again; where it comes off by itself, use another cable or port.</source>
        <translation>Der Trainer wurde ausgesteckt. Stecken Sie ihn wieder ein; wo er sich von selbst löst, nehmen Sie ein anderes Kabel oder einen anderen Anschluss.</translation>
    </message>
    <message>
        <source>The trainer sends nothing new. Press the reset button of its board; where that does not help, unplug it and plug it in again.</source>
        <translation>Der Trainer sendet nichts Neues. Drücken Sie die Reset-Taste seiner Platine; wo das nicht hilft, stecken Sie ihn aus und wieder ein.</translation>
    </message>
    <message>
        <source>What the trainer sends cannot be read. Press the reset button of its board, and load the sketch that came with this version of Fulcrum.</source>
        <translation>Was der Trainer sendet, kann nicht gelesen werden. Drücken Sie die Reset-Taste seiner Platine, und laden Sie den Sketch, der mit dieser Version von Fulcrum kam.</translation>
    </message>
    <message>
        <source>Lines of the trainer arrive damaged. Use a shorter cable, away from motors and electrosurgery, or a lower rate on both sides.</source>
        <translation>Zeilen des Trainers kommen beschädigt an. Nehmen Sie ein kürzeres Kabel, fern von Motoren und Elektrochirurgie, oder auf beiden Seiten eine kleinere Rate.</translation>
    </message>
    <message>
        <source>The trainer reports an angle or a length that is not possible. Check the plugs of its sensors and the ranges in its sketch.</source>
        <translation>Der Trainer meldet einen Winkel oder eine Länge, die nicht möglich sind. Prüfen Sie die Stecker seiner Sensoren und die Bereiche in seinem Sketch.</translation>
    </message>
    <message>
        <source>run `sudo usermod -aG dialout $USER` (the group that owns the port), then sign out and in again</source>
        <translation>führen Sie `sudo usermod -aG dialout $USER` aus (die Gruppe, der der Anschluss gehört), melden Sie sich dann ab und wieder an</translation>
    </message>
    <message>
        <source>write one of %1, in small letters; `fulcrum devices` lists what is connected</source>
        <translation>schreiben Sie eines von %1, in Kleinbuchstaben; `fulcrum devices` listet auf, was angeschlossen ist</translation>
    </message>
    <message>
        <source>use trainer:PORT, then baud=BITS (9600 to 1000000) or length=MM (100 to 600), each after a comma</source>
        <translation>verwenden Sie trainer:PORT, dann baud=BITS (9600 bis 1000000) oder length=MM (100 bis 600), jeweils nach einem Komma</translation>
    </message>
    <message>
        <source>no serial port of a micro-controller was found</source>
        <translation>es wurde kein serieller Anschluss eines Mikrocontrollers gefunden</translation>
    </message>
    <message>
        <source>plug the trainer in, or name its port: trainer:/dev/ttyUSB0</source>
        <translation>stecken Sie den Trainer ein, oder nennen Sie seinen Anschluss: trainer:/dev/ttyUSB0</translation>
    </message>
    <message>
        <source>more than one port can be the trainer&apos;s: %1</source>
        <translation>mehr als ein Anschluss kann der des Trainers sein: %1</translation>
    </message>
    <message>
        <source>name it: trainer:%1</source>
        <translation>nennen Sie ihn: trainer:%1</translation>
    </message>
    <message>
        <source>end the other program that uses it, such as the serial monitor of the Arduino program</source>
        <translation>beenden Sie das andere Programm, das ihn benutzt, etwa den seriellen Monitor des Arduino-Programms</translation>
    </message>
    <message>
        <source>name a serial port, such as /dev/ttyACM0</source>
        <translation>nennen Sie einen seriellen Anschluss, etwa /dev/ttyACM0</translation>
    </message>
    <message>
        <source>plug the trainer in; `fulcrum devices` shows whether it is found</source>
        <translation>stecken Sie den Trainer ein; `fulcrum devices` zeigt, ob er gefunden wird</translation>
    </message>
    <message>
        <source>the trainer&apos;s port does not open: %1</source>
        <translation>der Anschluss des Trainers lässt sich nicht öffnen: %1</translation>
    </message>
    <message>
        <source>the trainer was unplugged</source>
        <translation>der Trainer wurde ausgesteckt</translation>
    </message>
    <message>
        <source>plug it in, and use a cable and a port that hold it firmly</source>
        <translation>stecken Sie ihn ein, mit einem Kabel und an einem Anschluss, die fest sitzen</translation>
    </message>
    <message>
        <source>the trainer speaks version %1 of the protocol, Fulcrum version %2</source>
        <translation>der Trainer spricht Version %1 des Protokolls, Fulcrum Version %2</translation>
    </message>
    <message>
        <source>load the sketch that came with this version of Fulcrum</source>
        <translation>laden Sie den Sketch, der mit dieser Version von Fulcrum kam</translation>
    </message>
    <message>
        <source>the trainer sends angles or lengths that are not possible</source>
        <translation>der Trainer sendet Winkel oder Längen, die nicht möglich sind</translation>
    </message>
    <message>
        <source>set the ranges of its sensors in its sketch (docs/TRAINER.md)</source>
        <translation>stellen Sie die Bereiche seiner Sensoren in seinem Sketch ein (docs/TRAINER.md)</translation>
    </message>
    <message>
        <source>the trainer&apos;s lines have wrong checksums</source>
        <translation>die Zeilen des Trainers haben falsche Prüfsummen</translation>
    </message>
    <message>
        <source>use a shorter cable, or a lower rate on both sides</source>
        <translation>nehmen Sie ein kürzeres Kabel oder auf beiden Seiten eine kleinere Rate</translation>
    </message>
    <message>
        <source>what it sends are not the lines of a trainer</source>
        <translation>was er sendet, sind nicht die Zeilen eines Trainers</translation>
    </message>
    <message>
        <source>load the sketch of docs/trainer, and name its rate: trainer:PORT,baud=115200</source>
        <translation>laden Sie den Sketch aus docs/trainer, und nennen Sie seine Rate: trainer:PORT,baud=115200</translation>
    </message>
    <message>
        <source>no trainer answers</source>
        <translation>kein Trainer antwortet</translation>
    </message>
    <message>
        <source>check that this is its port, and load the sketch of docs/trainer</source>
        <translation>prüfen Sie, ob dies sein Anschluss ist, und laden Sie den Sketch aus docs/trainer</translation>
    </message>
    <message>
        <source>the trainer sends no pose of its instruments</source>
        <translation>der Trainer sendet keine Stellung seiner Instrumente</translation>
    </message>
    <message>
        <source>press the reset button of its board</source>
        <translation>drücken Sie die Reset-Taste seiner Platine</translation>
    </message>
    <message>
        <source>No sound: the sound device is gone. Connect it again, or another one.</source>
        <translation>Kein Ton: Das Tongerät ist nicht mehr da. Schließen Sie es wieder an oder ein anderes.</translation>
    </message>
    <message>
        <source>No sound: no sound device can be used (%1). Connect one, or choose one in the settings of the operating system.</source>
        <translation>Kein Ton: Es ist kein Tongerät nutzbar (%1). Schließen Sie eines an oder wählen Sie eines in den Einstellungen des Betriebssystems.</translation>
    </message>
    <message>
        <source>No sound: %1 (%2). To hear it, %3.</source>
        <translation>Kein Ton: %1 (%2). Um ihn zu hören: %3.</translation>
    </message>
    <message>
        <source>joystick</source>
        <translation>Joystick</translation>
    </message>
    <message>
        <source>connect it, then try again</source>
        <translation>schließen Sie ihn an und versuchen Sie es erneut</translation>
    </message>
    <message>
        <source>connect it, or calibrate the one that is connected</source>
        <translation>schließen Sie ihn an, oder kalibrieren Sie den angeschlossenen</translation>
    </message>
    <message>
        <source>is larger than 64 KiB</source>
        <translation>ist größer als 64 KiB</translation>
    </message>
    <message>
        <source>must be &quot;fulcrum-joystick&quot;</source>
        <translation>muss &quot;fulcrum-joystick&quot; sein</translation>
    </message>
    <message>
        <source>gives no hand the axes for pitch, yaw and insertion</source>
        <translation>gibt keiner Hand die Achsen für pitch, yaw und insertion</translation>
    </message>
    <message>
        <source>calibrate the joystick again: `fulcrum devices --calibrate joystick`</source>
        <translation>kalibrieren Sie den Joystick erneut: `fulcrum devices --calibrate joystick`</translation>
    </message>
    <message>
        <source>is not a usable number</source>
        <translation>ist keine brauchbare Zahl</translation>
    </message>
    <message>
        <source>has an angle or length that is not possible</source>
        <translation>hat einen Winkel oder eine Länge, die nicht möglich ist</translation>
    </message>
    <message>
        <source>has two ends that are the same</source>
        <translation>hat zwei gleiche Enden</translation>
    </message>
    <message>
        <source>the device reports a workspace that is not possible</source>
        <translation>das Gerät meldet einen Arbeitsraum, der nicht möglich ist</translation>
    </message>
    <message>
        <source>The maker&apos;s driver reports that the firmware of the device does not suit it. Update the firmware with the maker&apos;s program, or install the driver that belongs to it; then connect the device again.</source>
        <translation>Der Treiber des Herstellers meldet, dass die Firmware des Geräts nicht zu ihm passt. Aktualisieren Sie die Firmware mit dem Programm des Herstellers, oder installieren Sie den dazugehörigen Treiber; schließen Sie das Gerät dann wieder an.</translation>
    </message>
    <message>
        <source>must be two corners of a box in metres</source>
        <translation>muss aus zwei Ecken eines Quaders in Metern bestehen</translation>
    </message>
    <message>
        <source>write [-0.08, -0.06, -0.035, 0.08, 0.06, 0.035]</source>
        <translation>schreiben Sie [-0.08, -0.06, -0.035, 0.08, 0.06, 0.035]</translation>
    </message>
    <message>
        <source>is not calibrated</source>
        <translation>ist nicht kalibriert</translation>
    </message>
    <message>
        <source>run `fulcrum devices --calibrate joystick`, or use the button Calibrate on the page Settings</source>
        <translation>führen Sie `fulcrum devices --calibrate joystick` aus, oder wählen Sie „Kalibrieren“ auf der Seite Einstellungen</translation>
    </message>
    <message>
        <source>unplug the joystick and connect it again</source>
        <translation>ziehen Sie den Joystick ab und schließen Sie ihn wieder an</translation>
    </message>
    <message>
        <source>%1 has fewer axes than it was calibrated with</source>
        <translation>%1 hat weniger Achsen als bei der Kalibrierung</translation>
    </message>
    <message>
        <source>calibrate it again: `fulcrum devices --calibrate joystick`</source>
        <translation>kalibrieren Sie ihn erneut: `fulcrum devices --calibrate joystick`</translation>
    </message>
    <message>
        <source>update the firmware of the device with its maker&apos;s program, or install the driver that belongs to it</source>
        <translation>aktualisieren Sie die Firmware des Geräts mit dem Programm des Herstellers, oder installieren Sie den dazugehörigen Treiber</translation>
    </message>
    <message>
        <source>a value of the device is out of range</source>
        <translation>ein Wert des Geräts liegt außerhalb seines Bereichs</translation>
    </message>
    <message>
        <source>there is nothing to calibrate for this kind of device</source>
        <translation>bei dieser Art von Gerät gibt es nichts zu kalibrieren</translation>
    </message>
    <message>
        <source>The calibration was ended; nothing is stored.</source>
        <translation>Die Kalibrierung wurde beendet; nichts ist gespeichert.</translation>
    </message>
    <message>
        <source>Stored. It is valid for this joystick until its sensors are moved.</source>
        <translation>Gespeichert. Sie gilt für diesen Joystick, bis seine Sensoren versetzt werden.</translation>
    </message>
    <message>
        <source>Stored. It is valid until a sensor of the trainer is moved.</source>
        <translation>Gespeichert. Sie gilt, bis ein Sensor des Trainers versetzt wird.</translation>
    </message>
    <message>
        <source>Stored. It is valid for this controller, from now on.</source>
        <translation>Gespeichert. Sie gilt ab jetzt für diesen Controller.</translation>
    </message>
    <message>
        <source>Calibrated. It is valid until the device is switched off or unplugged.</source>
        <translation>Kalibriert. Das gilt, bis das Gerät ausgeschaltet oder abgezogen wird.</translation>
    </message>
    <message>
        <source>The device does not answer.</source>
        <translation>Das Gerät antwortet nicht.</translation>
    </message>
    <message>
        <source>It is at (%1, %2, %3) mm.</source>
        <translation>Es ist bei (%1, %2, %3) mm.</translation>
    </message>
    <message>
        <source>It could not be stored: %1</source>
        <translation>Sie konnte nicht gespeichert werden: %1</translation>
    </message>
    <message>
        <source>The device reports that it is not calibrated.</source>
        <translation>Das Gerät meldet, dass es nicht kalibriert ist.</translation>
    </message>
    <message>
        <source>The device reports that it is calibrated.</source>
        <translation>Das Gerät meldet, dass es kalibriert ist.</translation>
    </message>
    <message>
        <source>Hold the handle still in the middle of where you will work, for a second.</source>
        <translation>Halten Sie den Griff eine Sekunde lang ruhig, in der Mitte Ihres Arbeitsraums.</translation>
    </message>
    <message>
        <source>Put the stylus into the inkwell and leave it there for two seconds.</source>
        <translation>Stecken Sie den Stift in seine Halterung (Inkwell) und lassen Sie ihn dort zwei Sekunden.</translation>
    </message>
    <message>
        <source>Put the handle into its rest, and leave it there until the Inverse service reports that it is calibrated.</source>
        <translation>Legen Sie den Griff in seine Halterung, bis der Dienst Inverse meldet, dass er kalibriert ist.</translation>
    </message>
    <message>
        <source>Put the handle on its calibration pole or push it to its stops, as the maker&apos;s manual says, until its light stops blinking.</source>
        <translation>Setzen Sie den Griff auf seinen Kalibrierstift oder drücken Sie ihn an seine Anschläge, wie es die Anleitung des Herstellers sagt, bis seine Leuchte nicht mehr blinkt.</translation>
    </message>
    <message>
        <source>has no instrument for this hand</source>
        <translation>hat kein Instrument für diese Hand</translation>
    </message>
    <message>
        <source>choose the other hand</source>
        <translation>wählen Sie die andere Hand</translation>
    </message>
    <message>
        <source>Hold the instrument level and straight away from you, its jaws upright, and keep it still.</source>
        <translation>Halten Sie das Instrument waagerecht und gerade von sich weg, die Branchen aufrecht, und halten Sie es ruhig.</translation>
    </message>
    <message>
        <source>Hold the instrument straight away from you, half way in, its jaws open, and keep it still.</source>
        <translation>Halten Sie das Instrument gerade von sich weg, halb eingeführt, die Branchen offen, und halten Sie es ruhig.</translation>
    </message>
    <message>
        <source>Move the tip from all the way down to all the way up; stop there.</source>
        <translation>Bewegen Sie die Spitze von ganz unten nach ganz oben; bleiben Sie dort.</translation>
    </message>
    <message>
        <source>Move the tip from all the way left to all the way right; stop there.</source>
        <translation>Bewegen Sie die Spitze von ganz links nach ganz rechts; bleiben Sie dort.</translation>
    </message>
    <message>
        <source>Pull the instrument all the way out, then push it all the way in; stop there.</source>
        <translation>Ziehen Sie das Instrument ganz heraus, dann schieben Sie es ganz hinein; bleiben Sie dort.</translation>
    </message>
    <message>
        <source>Turn the shaft all the way counterclockwise, then all the way clockwise as you see it; stop there.</source>
        <translation>Drehen Sie den Schaft ganz gegen den Uhrzeigersinn, dann ganz im Uhrzeigersinn, von Ihnen aus gesehen; bleiben Sie dort.</translation>
    </message>
    <message>
        <source>Close the jaws, then open them all the way; stop there.</source>
        <translation>Schließen Sie die Branchen, dann öffnen Sie sie ganz; bleiben Sie dort.</translation>
    </message>
    <message>
        <source>It moves.</source>
        <translation>Es bewegt sich.</translation>
    </message>
    <message>
        <source>No axis moved from one end to the other yet.</source>
        <translation>Noch keine Achse ging von einem Ende zum anderen.</translation>
    </message>
    <message>
        <source>Seen.</source>
        <translation>Gesehen.</translation>
    </message>
    <message>
        <source>Turn each stick along its edge once, and press each trigger all the way.</source>
        <translation>Führen Sie jeden Stick einmal an seinem Rand entlang, und drücken Sie jeden Trigger ganz.</translation>
    </message>
    <message>
        <source>Not all sticks and triggers went to all their ends yet.</source>
        <translation>Noch waren nicht alle Sticks und Trigger an allen ihren Enden.</translation>
    </message>
    <message>
        <source>Let go of both sticks.</source>
        <translation>Lassen Sie beide Sticks los.</translation>
    </message>
    <message>
        <source>Both are in their middle.</source>
        <translation>Beide sind in ihrer Mitte.</translation>
    </message>
    <message>
        <source>A stick is not in its middle.</source>
        <translation>Ein Stick ist nicht in seiner Mitte.</translation>
    </message>
    <message>
        <source>needs no calibration</source>
        <translation>braucht keine Kalibrierung</translation>
    </message>
    <message>
        <source>use it as it is</source>
        <translation>verwenden Sie es so</translation>
    </message>
    <message>
        <source>has no meaning without --calibrate</source>
        <translation>hat ohne --calibrate keine Bedeutung</translation>
    </message>
    <message>
        <source>name a device: --calibrate DEVICE</source>
        <translation>nennen Sie ein Gerät: --calibrate DEVICE</translation>
    </message>
    <message>
        <source>The device stopped its motors for safety: its brake triggered, it stalled or it became unstable. Let go of the handle for three seconds, then resume; move it more slowly.</source>
        <translation>Das Gerät hat seine Motoren zur Sicherheit angehalten: Seine Bremse hat ausgelöst, es ist blockiert oder wurde instabil. Lassen Sie den Griff drei Sekunden lang los und machen Sie dann weiter; bewegen Sie ihn langsamer.</translation>
    </message>
    <message>
        <source>you have no permission to use the socket of spacenavd</source>
        <translation>Sie haben keine Berechtigung, den Socket von spacenavd zu benutzen</translation>
    </message>
    <message>
        <source>ask the administrator for the right to it: `sudo chmod a+rw %1`, and a+x for the folder that it is in</source>
        <translation>bitten Sie die Administration um das Recht dazu: `sudo chmod a+rw %1`, und a+x für seinen Ordner</translation>
    </message>
    <message>
        <source>the server was set up by an older program</source>
        <translation>der Server wurde von einer älteren Software eingerichtet</translation>
    </message>
    <message>
        <source>have its administrator run `fulcrum server create` with this program; nothing is lost</source>
        <translation>lassen Sie seinen Administrator `fulcrum server create` mit dieser Software ausführen; nichts ist verloren</translation>
    </message>
    <message>
        <source>ask the server&apos;s owner for a new one (`fulcrum server enrol`)</source>
        <translation>lassen Sie sich vom Eigentümer des Servers ein neues geben (`fulcrum server enrol`)</translation>
    </message>
    <message>
        <source>the token was good until %1</source>
        <translation>das Token galt bis %1</translation>
    </message>
    <message>
        <source>%1: does not know this token</source>
        <translation>%1: kennt dieses Token nicht</translation>
    </message>
    <message>
        <source>it is for another server, or it was withdrawn: check the address, or ask the server&apos;s owner for a new one (`fulcrum server enrol`)</source>
        <translation>es ist für einen anderen Server oder wurde zurückgezogen: Prüfen Sie die Adresse, oder lassen Sie sich vom Eigentümer des Servers ein neues geben (`fulcrum server enrol`)</translation>
    </message>
    <message>
        <source>this station has used this token already, on %1</source>
        <translation>diese Station hat dieses Token schon verwendet, am %1</translation>
    </message>
    <message>
        <source>run `fulcrum sync`; if the password of its account was lost, ask the server&apos;s owner for a new token (`fulcrum server enrol`)</source>
        <translation>führen Sie `fulcrum sync` aus; ist das Passwort ihres Kontos verloren, lassen Sie sich vom Eigentümer des Servers ein neues Token geben (`fulcrum server enrol`)</translation>
    </message>
    <message>
        <source>another station has used this token, on %1: %2</source>
        <translation>eine andere Station hat dieses Token verwendet, am %1: %2</translation>
    </message>
    <message>
        <source>each station needs its own: ask the server&apos;s owner for a new one (`fulcrum server enrol`), and tell them if that station is not known</source>
        <translation>jede Station braucht ihr eigenes: Lassen Sie sich vom Eigentümer des Servers ein neues geben (`fulcrum server enrol`), und sagen Sie es ihm, wenn jene Station nicht bekannt ist</translation>
    </message>
    <message>
        <source>the token was withdrawn on %1</source>
        <translation>das Token wurde am %1 zurückgezogen</translation>
    </message>
    <message>
        <source>the server knows this station with another signing key</source>
        <translation>der Server kennt diese Station mit einem anderen Signaturschlüssel</translation>
    </message>
    <message>
        <source>put the copy of its key back; if the key is lost, have the server&apos;s owner run `fulcrum server withdraw %1` first</source>
        <translation>legen Sie die Kopie ihres Schlüssels zurück; ist er verloren, lassen Sie den Eigentümer des Servers zuerst `fulcrum server withdraw %1` ausführen</translation>
    </message>
    <message>
        <source>the token %1</source>
        <translation>das Token %1</translation>
    </message>
    <message>
        <source>copy it again from `fulcrum server enrol`, whole; nothing was sent, so it is still good</source>
        <translation>übernehmen Sie es noch einmal ganz aus der Ausgabe von `fulcrum server enrol`; es wurde nichts gesendet, also gilt es noch</translation>
    </message>
    <message>
        <source>contains &apos;%1&apos;, which no token does</source>
        <translation>enthält „%1“, das in keinem Token vorkommt</translation>
    </message>
    <message>
        <source>has %1 characters instead of %2</source>
        <translation>hat %1 Zeichen statt %2</translation>
    </message>
    <message>
        <source>is mistyped</source>
        <translation>enthält einen Tippfehler</translation>
    </message>
    <message>
        <source>this account of the server is that of another station (%1)</source>
        <translation>dieses Konto des Servers gehört einer anderen Station (%1)</translation>
    </message>
    <message>
        <source>enrol this station with a token of its own (`fulcrum server enrol`, then `fulcrum sync --enrol TOKEN`)</source>
        <translation>nehmen Sie diese Station mit einem eigenen Token auf (`fulcrum server enrol`, dann `fulcrum sync --enrol TOKEN`)</translation>
    </message>
    <message>
        <source>this station was not enrolled at a programme server</source>
        <translation>diese Station ist auf keinem Programmserver aufgenommen</translation>
    </message>
    <message>
        <source>ask the server&apos;s owner for a token (`fulcrum server enrol`) and give it with `fulcrum sync --to ADDRESS --enrol TOKEN`</source>
        <translation>lassen Sie sich vom Eigentümer des Servers ein Token geben (`fulcrum server enrol`), und verwenden Sie es mit `fulcrum sync --to ADRESSE --enrol TOKEN`</translation>
    </message>
    <message>
        <source>%1: has no cohort %2</source>
        <translation>%1: hat keine Gruppe %2</translation>
    </message>
    <message>
        <source>sync the station where the cohort was made first, and write its name as there</source>
        <translation>gleichen Sie zuerst die Station ab, an der die Gruppe angelegt wurde, und schreiben Sie ihren Namen wie dort</translation>
    </message>
    <message>
        <source>a token is good for %1 to %2 hours (not %3)</source>
        <translation>ein Token gilt %1 bis %2 Stunden (nicht %3)</translation>
    </message>
    <message>
        <source>choose as long as it takes to reach the station</source>
        <translation>wählen Sie so lange, wie es dauert, bis es an der Station ist</translation>
    </message>
    <message>
        <source>%1: has no token and no enrolled station %2</source>
        <translation>%1: hat kein Token und keine aufgenommene Station %2</translation>
    </message>
    <message>
        <source>give an id that `fulcrum server stations` prints</source>
        <translation>geben Sie eine Kennung an, die `fulcrum server stations` ausgibt</translation>
    </message>
    <message>
        <source>station %1: its log is signed by the key %2, not by %3, with which it was enrolled, nor by one that leads from it</source>
        <translation>Station %1: ihr Protokoll ist mit dem Schlüssel %2 signiert, nicht mit %3, mit dem sie aufgenommen wurde, und nicht mit einem, der darauf zurückgeht</translation>
    </message>
    <message>
        <source>%1: the programme server of this station: %2</source>
        <translation>%1: der Programmserver dieser Station: %2</translation>
    </message>
    <message>
        <source>make its folder readable and writable for you, or move the file away and enrol the station again</source>
        <translation>machen Sie seinen Ordner für sich lesbar und beschreibbar, oder legen Sie die Datei beiseite und nehmen Sie die Station neu auf</translation>
    </message>
    <message>
        <source>the trace of attempt %1 was not taken from the server: %2</source>
        <translation>die Aufzeichnung von Versuch %1 wurde nicht vom Server übernommen: %2</translation>
    </message>
    <message>
        <source>tell the server&apos;s administrator, who runs `fulcrum server check`</source>
        <translation>sagen Sie es dem Administrator des Servers, der `fulcrum server check` ausführt</translation>
    </message>
    <message>
        <source>the signature of audit row %1 of station %2 does not fit</source>
        <translation>die Signatur der Protokollzeile %1 von Station %2 passt nicht</translation>
    </message>
    <message>
        <source>the station that recorded it has not signed it</source>
        <translation>die Station, die sie gemacht hat, hat sie nicht signiert</translation>
    </message>
    <message>
        <source>no audit row there says what it is</source>
        <translation>keine Protokollzeile dort sagt, was sie ist</translation>
    </message>
    <message>
        <source>a part of it does not match its checksum</source>
        <translation>ein Teil davon passt nicht zu seiner Prüfsumme</translation>
    </message>
    <message>
        <source>it is not as the station that recorded it has signed it</source>
        <translation>sie ist nicht so, wie die Station sie signiert hat, die sie gemacht hat</translation>
    </message>
    <message>
        <source>the server has no trace of attempt %1</source>
        <translation>der Server hat keine Aufzeichnung von Versuch %1</translation>
    </message>
    <message>
        <source>sync the station that recorded it, then try again</source>
        <translation>gleichen Sie die Station ab, die sie gemacht hat, und versuchen Sie es noch einmal</translation>
    </message>
    <message>
        <source>open it there, or fetch it with `fulcrum sync --trace %1`</source>
        <translation>öffnen Sie ihn dort, oder holen Sie die Aufzeichnung mit `fulcrum sync --trace %1`</translation>
    </message>
    <message>
        <source>the recording of this attempt is on the programme server, which cannot be reached now</source>
        <translation>die Aufzeichnung dieses Versuchs ist auf dem Programmserver, der jetzt nicht erreichbar ist</translation>
    </message>
    <message>
        <source>a kept key frame cannot be read, or does not match its checksum</source>
        <translation>ein aufbewahrter Zwischenstand kann nicht gelesen werden oder stimmt nicht mit seiner Prüfsumme überein</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is on the server, but the server never gave it to this station: it is not transferred, and the server&apos;s log has this; have the person added to a cohort of this station, or ask the server&apos;s owner for another token</source>
        <translation>%1: „%2“ ist auf dem Server, aber der Server hat dieser Station das nie gegeben: Es wird nicht übertragen, und das Protokoll des Servers hat es vermerkt; lassen Sie die Person in eine Gruppe dieser Station aufnehmen, oder bitten Sie den Inhaber des Servers um ein anderes Token</translation>
    </message>
    <message>
        <source>station %1: on %3 it named the person or cohort %2, which the server never gave to it, and was refused; if you cannot explain that, end its access (`fulcrum server withdraw %1`) and examine the station</source>
        <translation>Station %1: Am %3 hat sie die Person oder Gruppe %2 genannt, die der Server ihr nie gegeben hat, und wurde abgewiesen; wenn Sie das nicht erklären können, beenden Sie ihren Zugang (`fulcrum server withdraw %1`) und untersuchen Sie die Station</translation>
    </message>
    <message>
        <source>This station holds only some of the programme&apos;s cohorts. Reports from the programme server have all of yours.</source>
        <translation>Diese Station hat nur einen Teil der Gruppen des Programms. Berichte vom Programmserver enthalten alle Ihre Gruppen.</translation>
    </message>
    <message>
        <source>This station holds %1 of the programme&apos;s cohorts: %2. Reports from the programme server have all of them.</source>
        <translation>Diese Station hat %1 der Gruppen des Programms: %2. Berichte vom Programmserver enthalten alle.</translation>
    </message>
    <message>
        <source>the server does not accept the signature by which this station proves that it holds its key %1</source>
        <translation>der Server nimmt die Signatur nicht an, mit der diese Station zeigt, dass sie ihren Schlüssel %1 hat</translation>
    </message>
    <message>
        <source>the token was not used: install the same version of Fulcrum here and where `fulcrum server create` is run, then give the token again</source>
        <translation>das Token wurde nicht verbraucht: installieren Sie hier und dort, wo `fulcrum server create` ausgeführt wird, dieselbe Version von Fulcrum, und geben Sie das Token noch einmal ein</translation>
    </message>
    <message>
        <source>%1: was made by an older program, which does not ask a station to prove that it holds its key</source>
        <translation>%1: wurde von einem älteren Programm angelegt, das von einer Station keinen Nachweis verlangt, dass sie ihren Schlüssel hat</translation>
    </message>
    <message>
        <source>station %1: what the server keeps of its enrolment is not signed by the key %2, with which it was enrolled: end its access (`fulcrum server withdraw %1`), and find out who could write into the server&apos;s tables</source>
        <translation>Station %1: Was der Server von ihrer Aufnahme aufbewahrt, ist nicht mit dem Schlüssel %2 signiert, mit dem sie aufgenommen wurde: Beenden Sie ihren Zugang (`fulcrum server withdraw %1`), und finden Sie heraus, wer in die Tabellen des Servers schreiben konnte</translation>
    </message>
    <message>
        <source>station %1: was enrolled before stations proved that they hold their key (%2); enrol it again with a new token</source>
        <translation>Station %1: wurde aufgenommen, bevor Stationen nachwiesen, dass sie ihren Schlüssel haben (%2); nehmen Sie sie mit einem neuen Token noch einmal auf</translation>
    </message>
    <message>
        <source>the reason for confirming or striking an error has 1 to 1,000 characters</source>
        <translation>Der Grund, einen Fehler zu bestätigen oder zu streichen, hat 1 bis 1.000 Zeichen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no error that the program records of whoever performs</source>
        <translation>„%1“ ist kein Fehler, den das Programm bei der durchführenden Person aufzeichnet</translation>
    </message>
    <message>
        <source>choose an error in the list of events</source>
        <translation>wählen Sie einen Fehler in der Liste der Ereignisse</translation>
    </message>
    <message>
        <source>attempt %1 is still being recorded</source>
        <translation>Der Versuch %1 wird noch aufgezeichnet</translation>
    </message>
    <message>
        <source>the record of attempt %1 has no &apos;%2&apos; at tick %3 with this hand, tissue and detail</source>
        <translation>Die Aufzeichnung des Versuchs %1 hat bei Tick %3 kein „%2“ mit dieser Hand, diesem Gewebe und diesem Detail</translation>
    </message>
    <message>
        <source>open the attempt again and choose an error in the list of events</source>
        <translation>öffnen Sie den Versuch noch einmal und wählen Sie einen Fehler in der Liste der Ereignisse</translation>
    </message>
    <message>
        <source>errors of theirs that were confirmed or struck</source>
        <translation>ihre Fehler, die bestätigt oder gestrichen wurden</translation>
    </message>
    <message>
        <source>errors that they confirmed or struck</source>
        <translation>Fehler, die sie bestätigt oder gestrichen haben</translation>
    </message>
    <message>
        <source>errors confirmed or struck</source>
        <translation>bestätigte oder gestrichene Fehler</translation>
    </message>
    <message>
        <source>%1 backups cannot be kept</source>
        <translation>%1 Sicherungen können nicht behalten werden</translation>
    </message>
    <message>
        <source>give a number from 1 to %1</source>
        <translation>geben Sie eine Zahl von 1 bis %1 an</translation>
    </message>
    <message>
        <source>%1: this is not a folder</source>
        <translation>%1: das ist kein Ordner</translation>
    </message>
    <message>
        <source>backups that replace one another need a folder: make it, or name another one</source>
        <translation>Sicherungen, die einander ersetzen, brauchen einen Ordner: legen Sie ihn an, oder nennen Sie einen anderen</translation>
    </message>
    <message>
        <source>%1: the copy does not pass the check (%2: %3)</source>
        <translation>%1: die Kopie besteht die Prüfung nicht (%2: %3)</translation>
    </message>
    <message>
        <source>no backup was written and older ones are unchanged; run `fulcrum db check` on the store, and back it up to another disk if it passes there</source>
        <translation>es wurde keine Sicherung geschrieben, und ältere sind unverändert; prüfen Sie den Datenspeicher mit `fulcrum db check`, und sichern Sie ihn auf einen anderen Datenträger, wenn er dort besteht</translation>
    </message>
    <message>
        <source>table %1: it or an index of it is damaged</source>
        <translation>Tabelle %1: sie oder einer ihrer Indizes ist beschädigt</translation>
    </message>
    <message>
        <source>%1: it is missing</source>
        <translation>%1: fehlt</translation>
    </message>
    <message>
        <source>%1: its definition was changed</source>
        <translation>%1: die Definition wurde geändert</translation>
    </message>
    <message>
        <source>%1: this is not a part of a Fulcrum store</source>
        <translation>%1: das gehört nicht zu einem Fulcrum-Datenspeicher</translation>
    </message>
    <message>
        <source>restore the newest backup; nothing was changed (`fulcrum db check` lists all damage)</source>
        <translation>stellen Sie die neueste Sicherung wieder her; nichts wurde geändert (`fulcrum db check` führt alle Schäden auf)</translation>
    </message>
    <message>
        <source>simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>accounts</source>
        <translation>Konten</translation>
    </message>
    <message>
        <source>criteria of the scores</source>
        <translation>Kriterien der Bewertungen</translation>
    </message>
    <message>
        <source>measured values</source>
        <translation>gemessene Werte</translation>
    </message>
    <message>
        <source>critical errors</source>
        <translation>kritische Fehler</translation>
    </message>
    <message>
        <source>reports on specimens</source>
        <translation>Befunde zu Präparaten</translation>
    </message>
    <message>
        <source>parts of recordings</source>
        <translation>Teile von Aufzeichnungen</translation>
    </message>
    <message>
        <source>results of attempts, such as specimens</source>
        <translation>Ergebnisse von Versuchen, etwa Präparate</translation>
    </message>
    <message>
        <source>files that attempts were performed with</source>
        <translation>Dateien, mit denen Versuche durchgeführt wurden</translation>
    </message>
    <message>
        <source>states that practice began with</source>
        <translation>Zustände, mit denen Übungen begannen</translation>
    </message>
    <message>
        <source>recordings that are being made</source>
        <translation>laufende Aufzeichnungen</translation>
    </message>
    <message>
        <source>voided attempts</source>
        <translation>für ungültig erklärte Versuche</translation>
    </message>
    <message>
        <source>attempts that were assigned to another person</source>
        <translation>Versuche, die einer anderen Person zugeordnet wurden</translation>
    </message>
    <message>
        <source>comments by and about the person</source>
        <translation>Kommentare der Person und über sie</translation>
    </message>
    <message>
        <source>confirmed and struck errors</source>
        <translation>bestätigte und gestrichene Fehler</translation>
    </message>
    <message>
        <source>requests for a correction</source>
        <translation>Bitten um Berichtigung</translation>
    </message>
    <message>
        <source>observer forms</source>
        <translation>Beurteilungsbögen</translation>
    </message>
    <message>
        <source>items of observer forms</source>
        <translation>Punkte der Beurteilungsbögen</translation>
    </message>
    <message>
        <source>released observer forms</source>
        <translation>freigegebene Beurteilungsbögen</translation>
    </message>
    <message>
        <source>reviews that were seen before a rating</source>
        <translation>Auswertungen, die vor einer Beurteilung angesehen wurden</translation>
    </message>
    <message>
        <source>decisions on the standing</source>
        <translation>Entscheidungen über den Stand</translation>
    </message>
    <message>
        <source>moves to another curriculum</source>
        <translation>Umstellungen auf ein anderes Curriculum</translation>
    </message>
    <message>
        <source>personal goals that were dropped</source>
        <translation>aufgegebene persönliche Ziele</translation>
    </message>
    <message>
        <source>statements for a learning record store</source>
        <translation>Aussagen für einen Learning Record Store</translation>
    </message>
    <message>
        <source>passwords (stored as verifiers)</source>
        <translation>Passwörter (als Prüfwerte gespeichert)</translation>
    </message>
    <message>
        <source>roles</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>memberships of cohorts</source>
        <translation>Zugehörigkeiten zu Gruppen</translation>
    </message>
    <message>
        <source>cohorts that the person teaches</source>
        <translation>Gruppen, die die Person ausbildet</translation>
    </message>
    <message>
        <source>last sign-in at each station</source>
        <translation>letzte Anmeldung an jedem Arbeitsplatz</translation>
    </message>
    <message>
        <source>audit log: what was done to and by the person</source>
        <translation>Protokoll: was an der Person und von ihr getan wurde</translation>
    </message>
    <message>
        <source>%1: another export is being written there</source>
        <translation>%1: Dorthin wird gerade ein anderer Export geschrieben</translation>
    </message>
    <message>
        <source>wait until it is complete, or choose another name</source>
        <translation>warten Sie, bis er vollständig ist, oder wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>What %1 has stored about a person</source>
        <translation>Was %1 über eine Person gespeichert hat</translation>
    </message>
    <message>
        <source>all files</source>
        <translation>alle Dateien</translation>
    </message>
    <message>
        <source>Files of tables open in a spreadsheet; times are UTC. Recordings are packed with gzip. The password is not stored, only a verifier of it, which is not in these files.</source>
        <translation>Die Dateien der Tabellen lassen sich in einer Tabellenkalkulation öffnen; Zeiten sind in UTC. Aufzeichnungen sind mit gzip gepackt. Das Passwort ist nicht gespeichert, nur ein Prüfwert davon, der nicht in diesen Dateien ist.</translation>
    </message>
    <message>
        <source>reading what is stored</source>
        <translation>Gespeichertes wird gelesen</translation>
    </message>
    <message>
        <source>writing the recordings</source>
        <translation>Aufzeichnungen werden geschrieben</translation>
    </message>
    <message>
        <source>data cannot be kept for %1 months</source>
        <translation>Daten können nicht %1 Monate aufbewahrt werden</translation>
    </message>
    <message>
        <source>%1: this person is not due to be erased</source>
        <translation>%1: Die Zeit dieser Person ist nicht abgelaufen</translation>
    </message>
    <message>
        <source>look at the list again; nobody was erased</source>
        <translation>sehen Sie die Liste noch einmal an; niemand wurde gelöscht</translation>
    </message>
    <message>
        <source>erasing people</source>
        <translation>Personen werden gelöscht</translation>
    </message>
    <message>
        <source>cannot be used with --keep</source>
        <translation>lässt sich nicht mit --keep verwenden</translation>
    </message>
    <message>
        <source>a copy that nobody has verified replaces no backup</source>
        <translation>eine Kopie, die niemand geprüft hat, ersetzt keine Sicherung</translation>
    </message>
    <message>
        <source>name a new folder for the files</source>
        <translation>nennen Sie einen neuen Ordner für die Dateien</translation>
    </message>
    <message>
        <source>%1 people are due, not %2</source>
        <translation>die Zeit von %1 Personen ist abgelaufen, nicht von %2</translation>
    </message>
    <message>
        <source>look at the list again (without --erase), then give its number</source>
        <translation>sehen Sie die Liste noch einmal an (ohne --erase), und nennen Sie dann ihre Anzahl</translation>
    </message>
    <message>
        <source>cannot be used with --months and --off</source>
        <translation>lässt sich nicht mit --months und --off verwenden</translation>
    </message>
    <message>
        <source>set the time first, then look at the list</source>
        <translation>legen Sie zuerst die Zeit fest, und sehen Sie dann die Liste an</translation>
    </message>
    <message>
        <source>attempt %1: its record is not what its inputs give, from %2 s on</source>
        <translation>Versuch %1: Seine Aufzeichnung ist ab %2 s nicht das, was seine Eingaben ergeben</translation>
    </message>
    <message>
        <source>attempt %1: it ends in another state than the store has of it</source>
        <translation>Versuch %1: Er endet in einem anderen Zustand, als der Datenbestand von ihm hat</translation>
    </message>
    <message>
        <source>attempt %1: its events are not those that its inputs give</source>
        <translation>Versuch %1: Seine Ereignisse sind nicht die, die seine Eingaben ergeben</translation>
    </message>
    <message>
        <source>attempt %1: its score is not what its record gives</source>
        <translation>Versuch %1: Seine Bewertung ist nicht das, was seine Aufzeichnung ergibt</translation>
    </message>
    <message>
        <source>%1 attempts drawn of %2 with the seed %3</source>
        <translation>%1 von %2 Versuchen mit dem Startwert %3 gezogen</translation>
    </message>
    <message>
        <source>%1 attempts of other versions of the program, or taken over from a moment, cannot be simulated here</source>
        <translation>%1 Versuche anderer Versionen der Software oder solche, die ab einem Moment übernommen wurden, lassen sich hier nicht simulieren</translation>
    </message>
    <message>
        <source>attempt %1: not simulated, the time was over</source>
        <translation>Versuch %1: nicht simuliert, die Zeit war abgelaufen</translation>
    </message>
    <message>
        <source>attempt %1: not simulated, its task&apos;s file was changed since</source>
        <translation>Versuch %1: nicht simuliert, die Datei seiner Aufgabe wurde seither geändert</translation>
    </message>
    <message>
        <source>attempt %1: simulated, %2 samples compared</source>
        <translation>Versuch %1: simuliert, %2 Abtastwerte verglichen</translation>
    </message>
    <message>
        <source>attempt %1: simulated until the time was over</source>
        <translation>Versuch %1: simuliert, bis die Zeit abgelaufen war</translation>
    </message>
    <message>
        <source>attempt %1: not simulated (%2)</source>
        <translation>Versuch %1: nicht simuliert (%2)</translation>
    </message>
    <message>
        <source>attempt %1: cannot be read (%2)</source>
        <translation>Versuch %1: nicht lesbar (%2)</translation>
    </message>
    <message>
        <source>%1: fewer than %2 experts are left with a value after the outlier rule</source>
        <translation>%1: nach der Ausreißerregel bleiben weniger als %2 Experten mit einem Wert</translation>
    </message>
    <message>
        <source>%1 experts where %2 are needed</source>
        <translation>%1 Experten, wo %2 nötig sind</translation>
    </message>
    <message>
        <source>%1 has %2 counted attempts where %3 are needed</source>
        <translation>%1 hat %2 gezählte Versuche, wo %3 nötig sind</translation>
    </message>
    <message>
        <source>fewer than %1 familiarisation attempts came before the counted ones</source>
        <translation>vor den gezählten Versuchen lagen weniger als %1 Versuche zur Eingewöhnung</translation>
    </message>
    <message>
        <source>without %1: %2</source>
        <translation>ohne %1: %2</translation>
    </message>
    <message>
        <source>only %1 % of the experts&apos; own attempts pass all gates at k = %2, the best of all, where %3 % are needed</source>
        <translation>nur %1 % der eigenen Versuche der Experten bestehen alle Kriterien bei k = %2, dem besten von allen, wo %3 % nötig sind</translation>
    </message>
    <message>
        <source>the attempts of %1 are simulated, those of %2 are not</source>
        <translation>die Versuche von %1 sind simuliert, die von %2 nicht</translation>
    </message>
    <message>
        <source>version %1 of %2 is in force, so that version %3 cannot follow it</source>
        <translation>Version %1 von %2 gilt, sodass Version %3 nicht auf sie folgen kann</translation>
    </message>
    <message>
        <source>save the set; the administrator puts the file there, and an educator accepts it with `fulcrum assets accept`</source>
        <translation>Speichern Sie den Satz; der Administrator legt die Datei dorthin, und ein Ausbilder nimmt sie mit `fulcrum assets accept` an</translation>
    </message>
    <message>
        <source>its contents are not those that were accepted</source>
        <translation>der Inhalt ist nicht der, der zugelassen wurde</translation>
    </message>
    <message>
        <source>such a file has the name %1</source>
        <translation>eine solche Datei heißt %1</translation>
    </message>
    <message>
        <source>another curriculum of this version is in force here, which was accepted later; an educator publishes the next version</source>
        <translation>hier gilt ein anderes Curriculum dieser Version, das später zugelassen wurde; ein Ausbilder veröffentlicht die nächste Version</translation>
    </message>
    <message>
        <source>%1: %2 of this station are not sent, because it has some cohorts only: publish them at a station that has the whole programme</source>
        <translation>%1: %2 dieser Station werden nicht gesendet, weil sie nur einige Gruppen hat: veröffentlichen Sie sie an einer Station mit dem ganzen Programm</translation>
    </message>
    <message>
        <source>contents of accepted files</source>
        <translation>Inhalte zugelassener Dateien</translation>
    </message>
    <message>
        <source>a word in a row of table %1 has a control character</source>
        <translation>ein Wort in einer Zeile der Tabelle %1 enthält ein Steuerzeichen</translation>
    </message>
    <message>
        <source>is the file that the set is written to</source>
        <translation>ist die Datei, in die der Satz geschrieben wird</translation>
    </message>
    <message>
        <source>name two files</source>
        <translation>nennen Sie zwei verschiedene Dateien</translation>
    </message>
    <message>
        <source>needs --attempts</source>
        <translation>braucht --attempts</translation>
    </message>
    <message>
        <source>name the file of attempts</source>
        <translation>nennen Sie die Datei mit den Versuchen</translation>
    </message>
    <message>
        <source>name another file, or remove this one so that all attempts are performed again</source>
        <translation>nennen Sie eine andere Datei, oder entfernen Sie diese, damit alle Versuche noch einmal ausgeführt werden</translation>
    </message>
    <message>
        <source>is not what benchmark build wrote</source>
        <translation>ist nicht, was benchmark build geschrieben hat</translation>
    </message>
    <message>
        <source>its attempts were not made with the same: %1</source>
        <translation>ihre Versuche entstanden nicht mit demselben: %1</translation>
    </message>
    <message>
        <source>add --other-program if only the rule for limits has changed since, or name another file</source>
        <translation>fügen Sie --other-program hinzu, wenn sich seither nur die Regel für Grenzwerte geändert hat, oder nennen Sie eine andere Datei</translation>
    </message>
    <message>
        <source>this program performs %1, seed %2, differently</source>
        <translation>dieses Programm führt %1, Startwert %2, anders aus</translation>
    </message>
    <message>
        <source>logins that begin with erased- belong to people who were erased</source>
        <translation>Anmeldenamen, die mit erased- beginnen, gehören gelöschten Personen</translation>
    </message>
    <message>
        <source>the login of %1 cannot be changed</source>
        <translation>der Anmeldename von %1 kann nicht geändert werden</translation>
    </message>
    <message>
        <source>choose the account of a person; simulated, external and erased people keep theirs</source>
        <translation>wählen Sie das Konto einer Person; simulierte, externe und gelöschte Personen behalten ihren</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is the login of one at this station and of another one on the server; neither is transferred until one of them gets another login (page People, or `fulcrum people login`)</source>
        <translation>%1: „%2“ ist der Anmeldename einer Person an dieser Station und einer anderen auf dem Server; keine von beiden wird übertragen, bis eine davon einen anderen Anmeldenamen bekommt (Seite Personen oder `fulcrum people login`)</translation>
    </message>
    <message>
        <source>%1: this store belongs to the account %2, whose key signs its audit log</source>
        <translation>%1: Dieser Datenbestand gehört dem Benutzerkonto %2, dessen Schlüssel sein Protokoll signiert</translation>
    </message>
    <message>
        <source>run the command as that account (`sudo -u %1 -H fulcrum …`), or name the folder of its keys in FULCRUM_STATION_KEYS</source>
        <translation>führen Sie den Befehl als dieses Benutzerkonto aus (`sudo -u %1 -H fulcrum …`), oder nennen Sie in FULCRUM_STATION_KEYS den Ordner seiner Schlüssel</translation>
    </message>
    <message>
        <source>this station holds only some of the programme&apos;s cohorts</source>
        <translation>diese Station hat nur einen Teil der Gruppen des Programms</translation>
    </message>
    <message>
        <source>export from the programme server, or at a station that has the whole programme: the counts of a part could be subtracted from the whole</source>
        <translation>exportieren Sie vom Programmserver oder an einer Station mit dem ganzen Programm: die Zahlen eines Teils ließen sich vom Ganzen abziehen</translation>
    </message>
    <message>
        <source>look at the draft with the changes of both, then publish it again</source>
        <translation>sehen Sie sich den Entwurf mit den Änderungen beider an und veröffentlichen Sie ihn dann erneut</translation>
    </message>
    <message>
        <source>%1 was published before, and is not in force here yet</source>
        <translation>%1 wurde vorher veröffentlicht und gilt hier noch nicht</translation>
    </message>
    <message>
        <source>look at the draft again; where this is repeated, `fulcrum assets place` says what is in the way</source>
        <translation>sehen Sie sich den Entwurf erneut an; wiederholt sich das, sagt `fulcrum assets place`, was im Weg ist</translation>
    </message>
    <message>
        <source>the draft has “%1”, version %2 has “%3”</source>
        <translation>im Entwurf steht „%1“, in Version %2 „%3“</translation>
    </message>
    <message>
        <source>decide it under “Changes by two authors”</source>
        <translation>entscheiden Sie es unter „Änderungen von zweien“</translation>
    </message>
    <message>
        <source>somebody has changed this file since you opened it</source>
        <translation>jemand hat diese Datei geändert, seit Sie sie geöffnet haben</translation>
    </message>
    <message>
        <source>save your draft under another name</source>
        <translation>speichern Sie Ihren Entwurf unter einem anderen Namen</translation>
    </message>
</context>
<context>
    <name>fulcrum::app::demo</name>
    <message>
        <source>Unpacking the demonstration</source>
        <translation>Die Vorführung wird entpackt</translation>
    </message>
</context>
<context>
    <name>fulcrum::attempts</name>
    <message>
        <source>practice</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>assessed</source>
        <translation>bewertet</translation>
    </message>
    <message>
        <source>completed</source>
        <translation>abgeschlossen</translation>
    </message>
    <message>
        <source>timed out</source>
        <translation>Zeit abgelaufen</translation>
    </message>
    <message>
        <source>abandoned</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>unterbrochen</translation>
    </message>
    <message>
        <source>simulator fault</source>
        <translation>Simulatorfehler</translation>
    </message>
    <message>
        <source>voided</source>
        <translation>ungültig</translation>
    </message>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
</context>
<context>
    <name>fulcrum::begin_place</name>
    <message>
        <source>%1 mm to the left</source>
        <translation>%1 mm nach links</translation>
    </message>
    <message>
        <source>%1 mm to the right</source>
        <translation>%1 mm nach rechts</translation>
    </message>
    <message>
        <source>%1 mm down</source>
        <translation>%1 mm nach unten</translation>
    </message>
    <message>
        <source>%1 mm up</source>
        <translation>%1 mm nach oben</translation>
    </message>
    <message>
        <source>%1 mm away from you</source>
        <translation>%1 mm von Ihnen weg</translation>
    </message>
    <message>
        <source>%1 mm towards you</source>
        <translation>%1 mm zu Ihnen hin</translation>
    </message>
    <message>
        <source>Left hand</source>
        <translation>Linke Hand</translation>
    </message>
    <message>
        <source>Right hand</source>
        <translation>Rechte Hand</translation>
    </message>
    <message>
        <source>%1: does not answer</source>
        <translation>%1: antwortet nicht</translation>
    </message>
    <message>
        <source>%1: move the handle %2</source>
        <translation>%1: Griff %2 bewegen</translation>
    </message>
    <message>
        <source>%1: no force, because the device has a fault</source>
        <translation>%1: keine Kraft, weil das Gerät eine Störung hat</translation>
    </message>
</context>
<context>
    <name>fulcrum::concerns</name>
    <message>
        <source>relapsed</source>
        <translation>zurückgefallen</translation>
    </message>
    <message>
        <source>check overdue</source>
        <translation>Kontrolle überfällig</translation>
    </message>
    <message>
        <source>ratings missing</source>
        <translation>Beurteilungen fehlen</translation>
    </message>
    <message>
        <source>plateau below the pass mark</source>
        <translation>Plateau unter der Bestehensgrenze</translation>
    </message>
    <message>
        <source>many attempts, not proficient</source>
        <translation>viele Versuche, nicht sicher beherrscht</translation>
    </message>
    <message>
        <source>stopped practising</source>
        <translation>übt nicht mehr</translation>
    </message>
</context>
<context>
    <name>fulcrum::device_list</name>
    <message>
        <source>SpaceMouse</source>
        <translation>SpaceMouse</translation>
    </message>
    <message>
        <source>mouse and keyboard</source>
        <translation>Maus und Tastatur</translation>
    </message>
    <message>
        <source>there is no screen here</source>
        <translation>hier gibt es keinen Bildschirm</translation>
    </message>
    <message>
        <source>start Fulcrum on a desktop, or set DISPLAY</source>
        <translation>starten Sie Fulcrum auf einer Arbeitsoberfläche, oder setzen Sie DISPLAY</translation>
    </message>
    <message>
        <source>two mice, one for each hand</source>
        <translation>zwei Mäuse, eine je Hand</translation>
    </message>
    <message>
        <source>no mouse that an X server with XInput 2.1 reads by itself</source>
        <translation>keine Maus, die ein X-Server mit XInput 2.1 einzeln liest</translation>
    </message>
    <message>
        <source>one mouse only</source>
        <translation>nur eine Maus</translation>
    </message>
    <message>
        <source>start Fulcrum in an X11 session and connect two mice</source>
        <translation>starten Sie Fulcrum in einer X11-Sitzung und schließen Sie zwei Mäuse an</translation>
    </message>
    <message>
        <source>connect a second mouse</source>
        <translation>schließen Sie eine zweite Maus an</translation>
    </message>
    <message>
        <source>virtual device: a script</source>
        <translation>virtuelles Gerät: ein Skript</translation>
    </message>
    <message>
        <source>virtual:SCRIPT.json, for practice only</source>
        <translation>virtual:SCRIPT.json, nur für Übungen</translation>
    </message>
    <message>
        <source>install fulcrum-hapticd next to fulcrum, or name it in FULCRUM_HAPTICD</source>
        <translation>installieren Sie fulcrum-hapticd neben fulcrum, oder nennen Sie es in FULCRUM_HAPTICD</translation>
    </message>
    <message>
        <source>two mice and keyboard</source>
        <translation>zwei Mäuse und Tastatur</translation>
    </message>
    <message>
        <source>no USB device of this kind was found</source>
        <translation>kein USB-Gerät dieser Art gefunden</translation>
    </message>
    <message>
        <source>connect it and its power supply; a model for a network card can be tried with `fulcrum devices --test`</source>
        <translation>schließen Sie es und seine Stromversorgung an; ein Modell für eine Netzwerkkarte lässt sich mit `fulcrum devices --test` versuchen</translation>
    </message>
    <message>
        <source>you have no permission to open the device</source>
        <translation>Sie haben keine Berechtigung, das Gerät zu öffnen</translation>
    </message>
    <message>
        <source>game controller</source>
        <translation>Gamecontroller</translation>
    </message>
    <message>
        <source>SDL does not know its sticks and buttons</source>
        <translation>SDL kennt seine Sticks und Tasten nicht</translation>
    </message>
    <message>
        <source>set SDL_GAMECONTROLLERCONFIG to its mapping, or use another controller</source>
        <translation>setzen Sie SDL_GAMECONTROLLERCONFIG auf seine Belegung, oder verwenden Sie einen anderen Controller</translation>
    </message>
    <message>
        <source>none is connected</source>
        <translation>keiner ist angeschlossen</translation>
    </message>
    <message>
        <source>SDL 2 does not start</source>
        <translation>SDL 2 startet nicht</translation>
    </message>
    <message>
        <source>connect one by cable or Bluetooth and switch it on; your account needs the right to read /dev/input/event*</source>
        <translation>schließen Sie einen mit Kabel oder Bluetooth an und schalten Sie ihn ein; Ihr Konto braucht das Recht, /dev/input/event* zu lesen</translation>
    </message>
    <message>
        <source>tracked instruments over OpenIGTLink</source>
        <translation>verfolgte Instrumente über OpenIGTLink</translation>
    </message>
    <message>
        <source>Fulcrum itself sends attempts at the port where a tracker is expected</source>
        <translation>Fulcrum selbst sendet Versuche an dem Port, an dem ein Tracker erwartet wird</translation>
    </message>
    <message>
        <source>switch that off, or name the tracker&apos;s server: FULCRUM_DEVICE=openigtlink:HOST:PORT</source>
        <translation>schalten Sie das aus, oder nennen Sie den Server des Trackers: FULCRUM_DEVICE=openigtlink:HOST:PORT</translation>
    </message>
    <message>
        <source>no server listens at port 18944 of this computer</source>
        <translation>an Port 18944 dieses Computers wartet kein Server</translation>
    </message>
    <message>
        <source>start PLUS, 3D Slicer or the tracker&apos;s program with an OpenIGTLink server; for one on another computer start Fulcrum with FULCRUM_DEVICE=openigtlink:HOST:PORT</source>
        <translation>starten Sie PLUS, 3D Slicer oder das Programm des Trackers mit einem OpenIGTLink-Server; für einen auf einem anderen Computer starten Sie Fulcrum mit FULCRUM_DEVICE=openigtlink:HOST:PORT</translation>
    </message>
    <message>
        <source>spacenavd, which reads it, does not run</source>
        <translation>spacenavd, das sie liest, läuft nicht</translation>
    </message>
    <message>
        <source>install the package spacenavd and start it with `sudo systemctl restart spacenavd`</source>
        <translation>installieren Sie das Paket spacenavd und starten Sie es mit `sudo systemctl restart spacenavd`</translation>
    </message>
    <message>
        <source>Haply Inverse3, VerseGrip</source>
        <translation>Haply Inverse3, VerseGrip</translation>
    </message>
    <message>
        <source>the Inverse service of Haply does not run: nothing listens at port 10001 of this computer</source>
        <translation>der Inverse-Dienst von Haply läuft nicht: An Port 10001 dieses Computers antwortet nichts</translation>
    </message>
    <message>
        <source>install the Inverse service from Haply and start it; connect the device and its power supply</source>
        <translation>installieren Sie den Inverse-Dienst von Haply und starten Sie ihn; schließen Sie das Gerät und sein Netzteil an</translation>
    </message>
    <message>
        <source>box trainer on a serial port</source>
        <translation>Box-Trainer an einem seriellen Anschluss</translation>
    </message>
    <message>
        <source>no serial port of a micro-controller was found</source>
        <translation>es wurde kein serieller Anschluss eines Mikrocontrollers gefunden</translation>
    </message>
    <message>
        <source>load the sketch of docs/trainer on a board with sensors and plug it in; a port of another kind is named: FULCRUM_DEVICE=trainer:PORT</source>
        <translation>laden Sie den Sketch aus docs/trainer auf eine Platine mit Sensoren und stecken Sie sie ein; ein anderer Anschluss wird genannt: FULCRUM_DEVICE=trainer:PORT</translation>
    </message>
    <message>
        <source>more than one serial port can be its port</source>
        <translation>mehr als ein serieller Anschluss kann der seine sein</translation>
    </message>
    <message>
        <source>unplug the others, or name the port: FULCRUM_DEVICE=trainer:PORT</source>
        <translation>stecken Sie die anderen aus, oder nennen Sie den Anschluss: FULCRUM_DEVICE=trainer:PORT</translation>
    </message>
    <message>
        <source>HID joystick as an instrument</source>
        <translation>HID-Joystick als Instrument</translation>
    </message>
    <message>
        <source>connect the joystick of the trainer; your account needs the right to read /dev/input/event*</source>
        <translation>schließen Sie den Joystick des Trainers an; Ihr Konto muss /dev/input/event* lesen dürfen</translation>
    </message>
    <message>
        <source>it is not calibrated</source>
        <translation>er ist nicht kalibriert</translation>
    </message>
    <message>
        <source>choose it here and calibrate it, or run `fulcrum devices --calibrate joystick`</source>
        <translation>wählen Sie ihn hier und kalibrieren Sie ihn, oder führen Sie `fulcrum devices --calibrate joystick` aus</translation>
    </message>
    <message>
        <source>you have no permission to use its socket</source>
        <translation>Sie haben keine Berechtigung, seinen Socket zu benutzen</translation>
    </message>
    <message>
        <source>ask the administrator for the right to read and write the socket</source>
        <translation>bitten Sie die Administration um das Recht, den Socket zu lesen und zu schreiben</translation>
    </message>
</context>
<context>
    <name>fulcrum::device_states</name>
    <message>
        <source>can be used</source>
        <translation>verwendbar</translation>
    </message>
    <message>
        <source>connected, cannot be used</source>
        <translation>verbunden, nicht verwendbar</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>nicht verbunden</translation>
    </message>
</context>
<context>
    <name>fulcrum::devices</name>
    <message>
        <source>haptic device</source>
        <translation>haptisches Gerät</translation>
    </message>
    <message>
        <source>tracked instruments</source>
        <translation>Instrumente mit Tracking</translation>
    </message>
    <message>
        <source>game controller</source>
        <translation>Gamecontroller</translation>
    </message>
    <message>
        <source>mouse and keyboard</source>
        <translation>Maus und Tastatur</translation>
    </message>
    <message>
        <source>synthetic operator</source>
        <translation>simulierter Operateur</translation>
    </message>
    <message>
        <source>external trace</source>
        <translation>externe Aufzeichnung</translation>
    </message>
</context>
<context>
    <name>fulcrum::event_lines</name>
    <message>
        <source>Step %1 begins</source>
        <translation>Schritt %1 beginnt</translation>
    </message>
    <message>
        <source>Target %1 held</source>
        <translation>Ziel %1 gehalten</translation>
    </message>
    <message>
        <source>Too much force: %1 N</source>
        <translation>Zu viel Kraft: %1 N</translation>
    </message>
    <message>
        <source>Perforation at %1 N</source>
        <translation>Perforation bei %1 N</translation>
    </message>
    <message>
        <source>Jaw pressure %1 kPa</source>
        <translation>Mauldruck %1 kPa</translation>
    </message>
    <message>
        <source>A piece of %1 mm² came free</source>
        <translation>Ein Stück von %1 mm² hat sich gelöst</translation>
    </message>
    <message>
        <source>Band %1 divided at %2 N</source>
        <translation>Strang %1 bei %2 N durchtrennt</translation>
    </message>
    <message>
        <source>Bleeding, %1 mL/min</source>
        <translation>Blutung, %1 mL/min</translation>
    </message>
    <message>
        <source>Bleeding stopped after %1 mL</source>
        <translation>Blutung nach %1 mL gestillt</translation>
    </message>
    <message>
        <source>Tip framed after %1 s without it</source>
        <translation>Spitze nach %1 s im Bild eingestellt</translation>
    </message>
    <message>
        <source>%1 samples lost</source>
        <translation>%1 Messwerte verloren</translation>
    </message>
    <message>
        <source>Too much force: %1 N (limit %2 N)</source>
        <translation>Zu viel Kraft: %1 N (Grenzwert %2 N)</translation>
    </message>
    <message>
        <source>Energy on %1 mm from the nerve</source>
        <translation>Strom ein, %1 mm vom Nerv entfernt</translation>
    </message>
    <message>
        <source>Clip on a bleeding point</source>
        <translation>Clip auf einer Blutungsquelle</translation>
    </message>
    <message>
        <source>Nerve divided by a blade</source>
        <translation>Nerv mit einer Klinge durchtrennt</translation>
    </message>
    <message>
        <source>Nerve injured by heat</source>
        <translation>Nerv durch Hitze verletzt</translation>
    </message>
</context>
<context>
    <name>fulcrum::events</name>
    <message>
        <source>attempt begins</source>
        <translation>Versuch beginnt</translation>
    </message>
    <message>
        <source>first movement</source>
        <translation>erste Bewegung</translation>
    </message>
    <message>
        <source>step begins</source>
        <translation>Schritt beginnt</translation>
    </message>
    <message>
        <source>step ends</source>
        <translation>Schritt endet</translation>
    </message>
    <message>
        <source>target shown</source>
        <translation>Ziel gezeigt</translation>
    </message>
    <message>
        <source>target held</source>
        <translation>Ziel gehalten</translation>
    </message>
    <message>
        <source>grasp</source>
        <translation>Griff</translation>
    </message>
    <message>
        <source>release</source>
        <translation>losgelassen</translation>
    </message>
    <message>
        <source>tissue slipped out of the jaws</source>
        <translation>Gewebe aus dem Maul abgerutscht</translation>
    </message>
    <message>
        <source>object dropped</source>
        <translation>Objekt fallen gelassen</translation>
    </message>
    <message>
        <source>same place grasped again</source>
        <translation>gleiche Stelle erneut gefasst</translation>
    </message>
    <message>
        <source>too much force</source>
        <translation>zu viel Kraft</translation>
    </message>
    <message>
        <source>force back within the limit</source>
        <translation>Kraft wieder unter dem Grenzwert</translation>
    </message>
    <message>
        <source>perforation</source>
        <translation>Perforation</translation>
    </message>
    <message>
        <source>collision of instruments</source>
        <translation>Kollision der Instrumente</translation>
    </message>
    <message>
        <source>contact with the wall</source>
        <translation>Kontakt mit der Wand</translation>
    </message>
    <message>
        <source>pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>resumed</source>
        <translation>fortgesetzt</translation>
    </message>
    <message>
        <source>device lost</source>
        <translation>Gerät ausgefallen</translation>
    </message>
    <message>
        <source>device back</source>
        <translation>Gerät wieder da</translation>
    </message>
    <message>
        <source>device gave an impossible reading</source>
        <translation>unmöglicher Messwert vom Gerät</translation>
    </message>
    <message>
        <source>simulation late</source>
        <translation>Simulation verzögert</translation>
    </message>
    <message>
        <source>simulator fault</source>
        <translation>Simulatorfehler</translation>
    </message>
    <message>
        <source>stiffness limited</source>
        <translation>Steifigkeit begrenzt</translation>
    </message>
    <message>
        <source>progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>completed</source>
        <translation>abgeschlossen</translation>
    </message>
    <message>
        <source>abandoned</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>time limit reached</source>
        <translation>Zeitgrenze erreicht</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>unterbrochen</translation>
    </message>
    <message>
        <source>samples lost</source>
        <translation>Messwerte verloren</translation>
    </message>
    <message>
        <source>tear</source>
        <translation>Riss</translation>
    </message>
    <message>
        <source>jaw pressure above the limit</source>
        <translation>Mauldruck über dem Grenzwert</translation>
    </message>
    <message>
        <source>cut begins</source>
        <translation>Schnitt beginnt</translation>
    </message>
    <message>
        <source>cut ends</source>
        <translation>Schnitt endet</translation>
    </message>
    <message>
        <source>cut advances</source>
        <translation>Schnitt rückt vor</translation>
    </message>
    <message>
        <source>traction across the cut</source>
        <translation>Zug quer zum Schnitt</translation>
    </message>
    <message>
        <source>step of the cut undone</source>
        <translation>Schnittschritt zurückgenommen</translation>
    </message>
    <message>
        <source>piece came free</source>
        <translation>Stück hat sich gelöst</translation>
    </message>
    <message>
        <source>energy on</source>
        <translation>Strom ein</translation>
    </message>
    <message>
        <source>energy off</source>
        <translation>Strom aus</translation>
    </message>
    <message>
        <source>band divided</source>
        <translation>Strang durchtrennt</translation>
    </message>
    <message>
        <source>bleeding begins</source>
        <translation>Blutung beginnt</translation>
    </message>
    <message>
        <source>bleeding stopped</source>
        <translation>Blutung gestillt</translation>
    </message>
    <message>
        <source>blood loss</source>
        <translation>Blutverlust</translation>
    </message>
    <message>
        <source>clip</source>
        <translation>Clip</translation>
    </message>
    <message>
        <source>heat dose</source>
        <translation>Wärmedosis</translation>
    </message>
    <message>
        <source>vessel injury</source>
        <translation>Gefäßverletzung</translation>
    </message>
    <message>
        <source>nerve injury</source>
        <translation>Nervenverletzung</translation>
    </message>
    <message>
        <source>instrument exchanged</source>
        <translation>Instrument gewechselt</translation>
    </message>
    <message>
        <source>fibres tore under too much tension</source>
        <translation>Fasern unter zu hoher Spannung gerissen</translation>
    </message>
    <message>
        <source>area of dead tissue</source>
        <translation>Fläche toten Gewebes</translation>
    </message>
    <message>
        <source>lens touched</source>
        <translation>Linsenkontakt</translation>
    </message>
    <message>
        <source>target lost</source>
        <translation>Ziel verloren</translation>
    </message>
</context>
<context>
    <name>fulcrum::fidelity</name>
    <message>
        <source>fast</source>
        <translation>schnell</translation>
    </message>
    <message>
        <source>standard</source>
        <translation>standard</translation>
    </message>
    <message>
        <source>fine</source>
        <translation>fein</translation>
    </message>
</context>
<context>
    <name>fulcrum::gates</name>
    <message>
        <source>benchmark</source>
        <translation>Richtwert</translation>
    </message>
    <message>
        <source>absolute limit</source>
        <translation>absoluter Grenzwert</translation>
    </message>
</context>
<context>
    <name>fulcrum::goals</name>
    <message>
        <source>Touch targets</source>
        <translation>Ziele berühren</translation>
    </message>
    <message>
        <source>Run the bowel</source>
        <translation>Darm durchmustern</translation>
    </message>
    <message>
        <source>Lift and hold</source>
        <translation>Anheben und halten</translation>
    </message>
    <message>
        <source>Take tension</source>
        <translation>Spannung aufnehmen</translation>
    </message>
    <message>
        <source>Divide the line</source>
        <translation>Linie durchtrennen</translation>
    </message>
    <message>
        <source>Let go</source>
        <translation>Loslassen</translation>
    </message>
    <message>
        <source>Divide bands</source>
        <translation>Stränge durchtrennen</translation>
    </message>
    <message>
        <source>Stop the bleeding</source>
        <translation>Blutung stillen</translation>
    </message>
    <message>
        <source>Palpate the bowel</source>
        <translation>Darm abtasten</translation>
    </message>
    <message>
        <source>Transfer objects</source>
        <translation>Objekte übergeben</translation>
    </message>
    <message>
        <source>Frame targets</source>
        <translation>Ziele einstellen</translation>
    </message>
    <message>
        <source>Follow the tip</source>
        <translation>Der Spitze folgen</translation>
    </message>
</context>
<context>
    <name>fulcrum::hands</name>
    <message>
        <source>left hand</source>
        <translation>linke Hand</translation>
    </message>
    <message>
        <source>right hand</source>
        <translation>rechte Hand</translation>
    </message>
</context>
<context>
    <name>fulcrum::instruments</name>
    <message>
        <source>grasper</source>
        <translation>Fasszange</translation>
    </message>
    <message>
        <source>probe</source>
        <translation>Taststab</translation>
    </message>
    <message>
        <source>shears</source>
        <translation>Ultraschallschere</translation>
    </message>
    <message>
        <source>hook</source>
        <translation>Haken</translation>
    </message>
    <message>
        <source>clip applier</source>
        <translation>Clipzange</translation>
    </message>
    <message>
        <source>suction</source>
        <translation>Sauger</translation>
    </message>
    <message>
        <source>scissors</source>
        <translation>Schere</translation>
    </message>
    <message>
        <source>bowel grasper</source>
        <translation>Darmfasszange</translation>
    </message>
</context>
<context>
    <name>fulcrum::key_actions</name>
    <message>
        <source>handle up</source>
        <translation>Griff nach oben</translation>
    </message>
    <message>
        <source>handle to the left</source>
        <translation>Griff nach links</translation>
    </message>
    <message>
        <source>handle down</source>
        <translation>Griff nach unten</translation>
    </message>
    <message>
        <source>handle to the right</source>
        <translation>Griff nach rechts</translation>
    </message>
    <message>
        <source>in</source>
        <translation>hinein</translation>
    </message>
    <message>
        <source>out</source>
        <translation>heraus</translation>
    </message>
    <message>
        <source>turn to the left</source>
        <translation>nach links drehen</translation>
    </message>
    <message>
        <source>turn to the right</source>
        <translation>nach rechts drehen</translation>
    </message>
    <message>
        <source>jaws stay closed, or open</source>
        <translation>Maul bleibt zu oder offen</translation>
    </message>
    <message>
        <source>look up</source>
        <translation>nach oben sehen</translation>
    </message>
    <message>
        <source>look to the left</source>
        <translation>nach links sehen</translation>
    </message>
    <message>
        <source>look down</source>
        <translation>nach unten sehen</translation>
    </message>
    <message>
        <source>look to the right</source>
        <translation>nach rechts sehen</translation>
    </message>
    <message>
        <source>light post to the left</source>
        <translation>Lichtanschluss nach links</translation>
    </message>
    <message>
        <source>light post to the right</source>
        <translation>Lichtanschluss nach rechts</translation>
    </message>
    <message>
        <source>camera head to the left</source>
        <translation>Kamerakopf nach links</translation>
    </message>
    <message>
        <source>camera head to the right</source>
        <translation>Kamerakopf nach rechts</translation>
    </message>
    <message>
        <source>the mouse takes the other hand</source>
        <translation>Maus nimmt die andere Hand</translation>
    </message>
    <message>
        <source>pedal (energy, suction)</source>
        <translation>Pedal (Energie, Sauger)</translation>
    </message>
    <message>
        <source>next instrument</source>
        <translation>nächstes Instrument</translation>
    </message>
    <message>
        <source>Left hand</source>
        <translation>Linke Hand</translation>
    </message>
    <message>
        <source>Right hand</source>
        <translation>Rechte Hand</translation>
    </message>
    <message>
        <source>Scope</source>
        <translation>Optik</translation>
    </message>
    <message>
        <source>Hand that the mouse moves</source>
        <translation>Hand, die die Maus bewegt</translation>
    </message>
    <message>
        <source>sound off, on</source>
        <translation>Ton aus, an</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
</context>
<context>
    <name>fulcrum::metric_names</name>
    <message>
        <source>lower is better</source>
        <translation>niedriger ist besser</translation>
    </message>
    <message>
        <source>higher is better</source>
        <translation>höher ist besser</translation>
    </message>
    <message>
        <source>for information only</source>
        <translation>nur zur Einordnung</translation>
    </message>
</context>
<context>
    <name>fulcrum::metrics</name>
    <message>
        <source>Path of the scope</source>
        <translation>Weg der Optik</translation>
    </message>
    <message>
        <source>How far the scope&apos;s lens travelled.</source>
        <translation>Wie weit sich die Linse der Optik bewegt hat.</translation>
    </message>
    <message>
        <source>the lens travelled {value}, above the limit of {limit}</source>
        <translation>die Linse legte {value} zurück, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>turn the light post towards the target first, then go there in one move</source>
        <translation>drehen Sie zuerst den Lichtanschluss zum Ziel und gehen Sie dann in einer Bewegung dorthin</translation>
    </message>
    <message>
        <source>Smoothness of the scope</source>
        <translation>Bewegungsruhe der Optik</translation>
    </message>
    <message>
        <source>Minus the logarithm of the dimensionless jerk of the lens&apos;s speed, median over its movements. Nearer to 0 is smoother.</source>
        <translation>Negativer Logarithmus des dimensionslosen Rucks der Linsengeschwindigkeit, Median über ihre Bewegungen. Näher an 0 ist ruhiger.</translation>
    </message>
    <message>
        <source>the scope moved jerkily: log jerk {value}, below the required {limit}</source>
        <translation>die Optik bewegte sich ruckartig: logarithmischer Ruck {value}, unter dem geforderten Wert von {limit}</translation>
    </message>
    <message>
        <source>hold the scope with both hands and let each move run out</source>
        <translation>halten Sie die Optik mit beiden Händen und lassen Sie jede Bewegung auslaufen</translation>
    </message>
    <message>
        <source>Horizon</source>
        <translation>Horizont</translation>
    </message>
    <message>
        <source>Angle between the image&apos;s upright and the body&apos;s, on average from the first movement on.</source>
        <translation>Winkel zwischen der Senkrechten des Bildes und der des Körpers, im Mittel ab der ersten Bewegung.</translation>
    </message>
    <message>
        <source>the image was tilted by {value} on average, above the limit of {limit}</source>
        <translation>das Bild war im Mittel um {value} gekippt, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>turn the camera head back whenever the light post turns</source>
        <translation>drehen Sie den Kamerakopf zurück, sobald sich der Lichtanschluss dreht</translation>
    </message>
    <message>
        <source>Centring</source>
        <translation>Zentrierung</translation>
    </message>
    <message>
        <source>Angle between the line of sight and the target, on average over the last second of each hold.</source>
        <translation>Winkel zwischen Blickrichtung und Ziel, im Mittel über die letzte Sekunde jedes Haltens.</translation>
    </message>
    <message>
        <source>targets were {value} off the middle on average, above the limit of {limit}</source>
        <translation>die Ziele lagen im Mittel {value} neben der Bildmitte, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>bring the target to the middle before you hold still</source>
        <translation>bringen Sie das Ziel in die Bildmitte, bevor Sie stillhalten</translation>
    </message>
    <message>
        <source>Size in the image</source>
        <translation>Größe im Bild</translation>
    </message>
    <message>
        <source>How much larger or smaller than wanted targets were, on average over the last second of each hold.</source>
        <translation>Um wie viel größer oder kleiner als gewünscht die Ziele waren, im Mittel über die letzte Sekunde jedes Haltens.</translation>
    </message>
    <message>
        <source>the size of targets was off by {value} on average, above the limit of {limit}</source>
        <translation>die Größe der Ziele wich im Mittel um {value} ab, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>bring the rim of the target onto the circle before you hold still</source>
        <translation>bringen Sie den Rand des Ziels auf den Kreis, bevor Sie stillhalten</translation>
    </message>
    <message>
        <source>Tip out of the middle</source>
        <translation>Spitze außerhalb der Mitte</translation>
    </message>
    <message>
        <source>For how long the moving tip was not framed while it was to be followed, the search for it included.</source>
        <translation>Wie lange die bewegte Spitze nicht im Bild eingestellt war, während ihr zu folgen war, einschließlich der Suche nach ihr.</translation>
    </message>
    <message>
        <source>the tip was not framed for {value}, above the limit of {limit}</source>
        <translation>die Spitze war {value} lang nicht im Bild eingestellt, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>move with the tip, not after it</source>
        <translation>bewegen Sie sich mit der Spitze, nicht hinter ihr her</translation>
    </message>
    <message>
        <source>Lens contacts</source>
        <translation>Linsenkontakte</translation>
    </message>
    <message>
        <source>How often the lens touched something.</source>
        <translation>Wie oft die Linse etwas berührt hat.</translation>
    </message>
    <message>
        <source>the lens touched something {value} times, above the limit of {limit}</source>
        <translation>die Linse berührte {value}-mal etwas, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>withdraw a little before you look elsewhere</source>
        <translation>ziehen Sie die Optik etwas zurück, bevor Sie woandershin blicken</translation>
    </message>
    <message>
        <source>Handedness</source>
        <translation>Händigkeit</translation>
    </message>
    <message>
        <source>How unevenly the path is shared between the hands: 0 is half each, 50 is one hand alone.</source>
        <translation>Wie ungleich der Weg auf die Hände verteilt ist: 0 ist je die Hälfte, 50 ist eine Hand allein.</translation>
    </message>
    <message>
        <source>one hand did most of the travelling: {value} from an even share, above the limit of {limit}</source>
        <translation>eine Hand legte den größten Teil des Weges zurück: {value} Abweichung von gleichen Anteilen, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>pass work to the other hand on its own side</source>
        <translation>übergeben Sie der anderen Hand die Arbeit auf ihrer Seite</translation>
    </message>
    <message>
        <source>Bimanual coordination</source>
        <translation>Beidhändige Koordination</translation>
    </message>
    <message>
        <source>How much the two tips sped up and slowed down together (correlation of speeds).</source>
        <translation>Wie sehr beide Spitzen gemeinsam schneller und langsamer wurden (Korrelation der Geschwindigkeiten).</translation>
    </message>
    <message>
        <source>the hands moved one after the other: coordination {value}, below the required {limit}</source>
        <translation>die Hände bewegten sich nacheinander: Koordination {value}, unter dem geforderten Wert von {limit}</translation>
    </message>
    <message>
        <source>start the second hand&apos;s move before the first hand&apos;s ends</source>
        <translation>beginnen Sie die Bewegung der zweiten Hand, bevor die der ersten endet</translation>
    </message>
    <message>
        <source>Bimanual coordination, angular</source>
        <translation>Beidhändige Koordination, Winkel</translation>
    </message>
    <message>
        <source>How much the two shafts turned together (correlation of angular speeds).</source>
        <translation>Wie sehr sich beide Schäfte gemeinsam drehten (Korrelation der Winkelgeschwindigkeiten).</translation>
    </message>
    <message>
        <source>the shafts turned one after the other: coordination {value}, below the required {limit}</source>
        <translation>die Schäfte drehten sich nacheinander: Koordination {value}, unter dem geforderten Wert von {limit}</translation>
    </message>
    <message>
        <source>move both instruments towards the working point together</source>
        <translation>bewegen Sie beide Instrumente gemeinsam zum Arbeitspunkt</translation>
    </message>
    <message>
        <source>Simultaneous movement</source>
        <translation>Gleichzeitige Bewegung</translation>
    </message>
    <message>
        <source>Share of the time in which both tips were moving.</source>
        <translation>Anteil der Zeit, in der sich beide Spitzen bewegten.</translation>
    </message>
    <message>
        <source>both hands moved together for only {value} of the time, below the required {limit}</source>
        <translation>beide Hände bewegten sich nur während {value} der Zeit gemeinsam, unter dem geforderten Wert von {limit}</translation>
    </message>
    <message>
        <source>let the left hand prepare while the right hand works</source>
        <translation>lassen Sie die linke Hand vorbereiten, während die rechte arbeitet</translation>
    </message>
    <message>
        <source>Cutting time under tension</source>
        <translation>Schneidezeit unter Spannung</translation>
    </message>
    <message>
        <source>Share of the cutting time during which the tissue was held with the right tension: slack tissue does not open, tissue held too tightly tears.</source>
        <translation>Anteil der Schneidezeit, in der das Gewebe mit der richtigen Spannung gehalten wurde: Schlaffes Gewebe öffnet sich nicht, zu straff gehaltenes Gewebe reißt.</translation>
    </message>
    <message>
        <source>the tension was right for {value} of the cutting time, below the required {limit}</source>
        <translation>die Spannung war während {value} der Schneidezeit richtig, unter dem geforderten Wert von {limit}</translation>
    </message>
    <message>
        <source>before every stroke look whether the tissue is taut, and take a new hold when it is not</source>
        <translation>prüfen Sie vor jeder Schnittbewegung, ob das Gewebe gespannt ist, und fassen Sie nach, wenn nicht</translation>
    </message>
    <message>
        <source>Cut length under tension</source>
        <translation>Schnittlänge unter Spannung</translation>
    </message>
    <message>
        <source>Share of the length of the cut that was made with the right tension.</source>
        <translation>Anteil der Schnittlänge, der mit der richtigen Spannung geschnitten wurde.</translation>
    </message>
    <message>
        <source>{value} of the cut was made with the right tension, below the required {limit}</source>
        <translation>{value} des Schnitts entstanden mit der richtigen Spannung, unter dem geforderten Wert von {limit}</translation>
    </message>
    <message>
        <source>stop cutting when the tissue goes slack, take a new hold, and continue</source>
        <translation>hören Sie auf zu schneiden, wenn das Gewebe erschlafft, fassen Sie nach und schneiden Sie weiter</translation>
    </message>
    <message>
        <source>Area between line and cut</source>
        <translation>Fläche zwischen Linie und Schnitt</translation>
    </message>
    <message>
        <source>Area between the marked line and the cut that was made, all strokes together.</source>
        <translation>Fläche zwischen der markierten Linie und dem ausgeführten Schnitt, alle Schnittbewegungen zusammen.</translation>
    </message>
    <message>
        <source>the area between cut and line was {value}, above the limit of {limit}</source>
        <translation>die Fläche zwischen Schnitt und Linie betrug {value}, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>make short strokes and look at the line before each</source>
        <translation>machen Sie kurze Schnittbewegungen und sehen Sie vor jeder auf die Linie</translation>
    </message>
    <message>
        <source>Largest distance from the line</source>
        <translation>Größter Abstand von der Linie</translation>
    </message>
    <message>
        <source>Largest distance of the cut from the marked line.</source>
        <translation>Größter Abstand des Schnitts von der markierten Linie.</translation>
    </message>
    <message>
        <source>the cut strayed {value} from the line, above the limit of {limit}</source>
        <translation>der Schnitt wich {value} von der Linie ab, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>stop the stroke as soon as the blade leaves the line and start again on it</source>
        <translation>brechen Sie die Schnittbewegung ab, sobald die Klinge die Linie verlässt, und setzen Sie auf der Linie neu an</translation>
    </message>
    <message>
        <source>Typical distance from the plane</source>
        <translation>Typischer Abstand zur Schicht</translation>
    </message>
    <message>
        <source>Distance of the cut from the intended plane, whichever side: half of the cut is nearer.</source>
        <translation>Abstand des Schnitts zur vorgesehenen Schicht, gleich auf welcher Seite: Die Hälfte des Schnitts liegt näher.</translation>
    </message>
    <message>
        <source>half of the cut lay further than {value} from the plane, above the limit of {limit}</source>
        <translation>die Hälfte des Schnitts lag weiter als {value} von der Schicht entfernt, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>Side of the plane</source>
        <translation>Seite der Schicht</translation>
    </message>
    <message>
        <source>Median of the signed distance of the cut from the intended plane: above 0 too deep, below too shallow.</source>
        <translation>Median des Abstands des Schnitts zur vorgesehenen Schicht, mit Vorzeichen: über 0 zu tief, darunter zu flach.</translation>
    </message>
    <message>
        <source>the cut lay {value} to one side of the plane, above the limit of {limit}</source>
        <translation>der Schnitt lag {value} zu einer Seite der Schicht hin, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>aim for the middle of the stretched fibres, not for their edge</source>
        <translation>zielen Sie auf die Mitte der gespannten Fasern, nicht auf ihren Rand</translation>
    </message>
    <message>
        <source>Distance from the plane, 95th percentile</source>
        <translation>Abstand zur Schicht, 95. Perzentil</translation>
    </message>
    <message>
        <source>Distance from the intended plane that 95 % of the cut keeps.</source>
        <translation>Abstand zur vorgesehenen Schicht, den 95 % des Schnitts einhalten.</translation>
    </message>
    <message>
        <source>a twentieth of the cut lay further than {value} from the plane, above the limit of {limit}</source>
        <translation>ein Zwanzigstel des Schnitts lag weiter als {value} von der Schicht entfernt, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>stop when the plane is no longer clear and restore the tension first</source>
        <translation>halten Sie an, wenn die Schicht nicht mehr klar zu sehen ist, und stellen Sie zuerst die Spannung wieder her</translation>
    </message>
    <message>
        <source>Cut too deep</source>
        <translation>Schnitt zu tief</translation>
    </message>
    <message>
        <source>Share of the length of the cut that is deeper than the tolerance allows: towards what must be spared.</source>
        <translation>Anteil der Schnittlänge, der tiefer liegt, als die Toleranz erlaubt: zu dem hin, was geschont werden muss.</translation>
    </message>
    <message>
        <source>{value} of the cut was too deep, above the limit of {limit}</source>
        <translation>{value} des Schnitts lagen zu tief, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>keep the blade on the side of the flap that you hold</source>
        <translation>führen Sie die Klinge auf der Seite des Lappens, den Sie halten</translation>
    </message>
    <message>
        <source>Cut too shallow</source>
        <translation>Schnitt zu flach</translation>
    </message>
    <message>
        <source>Share of the length of the cut that is shallower than the tolerance allows: into what is taken away.</source>
        <translation>Anteil der Schnittlänge, der flacher liegt, als die Toleranz erlaubt: in das hinein, was entfernt wird.</translation>
    </message>
    <message>
        <source>{value} of the cut was too shallow, above the limit of {limit}</source>
        <translation>{value} des Schnitts lagen zu flach, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>follow the plane, not the edge of the flap</source>
        <translation>folgen Sie der Schicht, nicht dem Rand des Lappens</translation>
    </message>
    <message>
        <source>Line divided</source>
        <translation>Linie durchtrennt</translation>
    </message>
    <message>
        <source>Share of the marked line that was divided with a blade. What tore is not divided, also where a blade trims it afterwards.</source>
        <translation>Anteil der markierten Linie, der mit einer Klinge durchtrennt wurde. Was gerissen ist, gilt nicht als durchtrennt, auch wo es eine Klinge danach beschneidet.</translation>
    </message>
    <message>
        <source>{value} of the line was divided, below the required {limit}</source>
        <translation>{value} der Linie wurden durchtrennt, unter dem geforderten Wert von {limit}</translation>
    </message>
    <message>
        <source>Safe use of energy</source>
        <translation>Sicherer Einsatz von Strom</translation>
    </message>
    <message>
        <source>Share of the time with energy on that belongs to activations with the tip in view, on the tissue to be divided or sealed, and clear of the marked structure from beginning to end.</source>
        <translation>Anteil der Zeit mit Strom, der auf Aktivierungen entfällt, bei denen die Spitze von Anfang bis Ende im Bild war, an dem Gewebe lag, das durchtrennt oder versiegelt werden soll, und Abstand zur markierten Struktur hielt.</translation>
    </message>
    <message>
        <source>{value} of the time with energy on was safe, below the required {limit}</source>
        <translation>{value} der Zeit mit Strom waren sicher, unter dem geforderten Wert von {limit}</translation>
    </message>
    <message>
        <source>press the pedal only when the blade is in view, on the tissue to be divided and clear of the nerve</source>
        <translation>drücken Sie das Pedal nur, wenn die Klinge im Bild ist, am zu durchtrennenden Gewebe liegt und Abstand zum Nerv hat</translation>
    </message>
    <message>
        <source>Length divided under power</source>
        <translation>Mit Strom durchtrennte Länge</translation>
    </message>
    <message>
        <source>Share of the divided length that was divided with energy on: a hook has no edge, and fibres carry small vessels.</source>
        <translation>Anteil der durchtrennten Länge, der mit Strom durchtrennt wurde: Ein Haken hat keine Schneide, und Fasern führen kleine Gefäße.</translation>
    </message>
    <message>
        <source>{value} of the length was divided with energy on, below the required {limit}</source>
        <translation>{value} der Länge wurden mit Strom durchtrennt, unter dem geforderten Wert von {limit}</translation>
    </message>
    <message>
        <source>press the pedal in short activations while the blade divides, and divide cold only next to a nerve</source>
        <translation>drücken Sie das Pedal in kurzen Aktivierungen, während die Klinge durchtrennt, und durchtrennen Sie nur neben einem Nerv ohne Strom</translation>
    </message>
    <message>
        <source>Time with energy on</source>
        <translation>Zeit mit Strom</translation>
    </message>
    <message>
        <source>How long energy was on, all activations together.</source>
        <translation>Wie lange der Strom eingeschaltet war, alle Aktivierungen zusammen.</translation>
    </message>
    <message>
        <source>energy was on for {value}, above the limit of {limit}</source>
        <translation>der Strom war {value} lang eingeschaltet, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>release the pedal as soon as the tissue has parted</source>
        <translation>lassen Sie das Pedal los, sobald das Gewebe getrennt ist</translation>
    </message>
    <message>
        <source>Thermal spread</source>
        <translation>Wärmeausbreitung</translation>
    </message>
    <message>
        <source>Area of tissue that was not to be heated and received a dose that kills it (240 equivalent minutes at 43 degrees).</source>
        <translation>Fläche von Gewebe, das nicht erhitzt werden sollte und eine tödliche Wärmedosis erhielt (240 Äquivalentminuten bei 43 Grad).</translation>
    </message>
    <message>
        <source>heat killed {value} of non-target tissue, above the limit of {limit}</source>
        <translation>durch Hitze starben {value} Gewebe außerhalb des Zielgebiets ab, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>keep the hot blade away from the tissue behind it, and let it cool before touching</source>
        <translation>halten Sie die heiße Klinge vom Gewebe dahinter fern und lassen Sie sie abkühlen, bevor Sie etwas berühren</translation>
    </message>
    <message>
        <source>Blood lost</source>
        <translation>Blutverlust</translation>
    </message>
    <message>
        <source>Blood lost from all vessels.</source>
        <translation>Blutverlust aus allen Gefäßen.</translation>
    </message>
    <message>
        <source>{value} of blood were lost, above the limit of {limit}</source>
        <translation>der Blutverlust betrug {value}, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>seal a vessel slowly without traction, and clip a bleeding point before anything else</source>
        <translation>versiegeln Sie ein Gefäß langsam und ohne Zug, und clippen Sie eine Blutungsquelle vor allem anderen</translation>
    </message>
    <message>
        <source>Vessels injured</source>
        <translation>Verletzte Gefäße</translation>
    </message>
    <message>
        <source>Number of vessels torn or divided before they were sealed or clipped.</source>
        <translation>Zahl der Gefäße, die gerissen oder durchtrennt wurden, bevor sie versiegelt oder geclippt waren.</translation>
    </message>
    <message>
        <source>{value} vessels were torn or divided open, above the limit of {limit}</source>
        <translation>{value} Gefäße wurden offen gerissen oder durchtrennt, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>Nerve injured</source>
        <translation>Nerv verletzt</translation>
    </message>
    <message>
        <source>Number of injuries of the marked nerve, by heat or by a blade.</source>
        <translation>Zahl der Verletzungen des markierten Nervs, durch Hitze oder eine Klinge.</translation>
    </message>
    <message>
        <source>the nerve was injured {value} times, above the limit of {limit}</source>
        <translation>der Nerv wurde {value}-mal verletzt, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>divide on the side away from the nerve and let the blade cool</source>
        <translation>durchtrennen Sie auf der nervenfernen Seite und lassen Sie die Klinge abkühlen</translation>
    </message>
    <message>
        <source>Tears</source>
        <translation>Risse</translation>
    </message>
    <message>
        <source>Number of times tissue tore under traction.</source>
        <translation>Wie oft Gewebe unter Zug gerissen ist.</translation>
    </message>
    <message>
        <source>tissue tore {value} times, above the limit of {limit}</source>
        <translation>Gewebe riss {value}-mal, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>lift only until the tissue is taut</source>
        <translation>heben Sie nur an, bis das Gewebe gespannt ist</translation>
    </message>
    <message>
        <source>Largest force</source>
        <translation>Größte Kraft</translation>
    </message>
    <message>
        <source>Largest force of the instrument on tissue.</source>
        <translation>Größte Kraft des Instruments auf Gewebe.</translation>
    </message>
    <message>
        <source>the force rose to {value}, above the limit of {limit}</source>
        <translation>die Kraft stieg auf {value}, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>Force variation</source>
        <translation>Kraftschwankung</translation>
    </message>
    <message>
        <source>Standard deviation of the force while in contact.</source>
        <translation>Standardabweichung der Kraft während des Kontakts.</translation>
    </message>
    <message>
        <source>the force varied by {value}, above the limit of {limit}</source>
        <translation>die Kraft schwankte um {value}, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>take up tension once and keep it even</source>
        <translation>nehmen Sie die Spannung einmal auf und halten Sie sie gleichmäßig</translation>
    </message>
    <message>
        <source>Mean force in contact</source>
        <translation>Mittlere Kraft bei Kontakt</translation>
    </message>
    <message>
        <source>Mean force over the time in which it was above 0.1 N.</source>
        <translation>Mittlere Kraft über die Zeit, in der sie über 0,1 N lag.</translation>
    </message>
    <message>
        <source>the mean force was {value}, above the limit of {limit}</source>
        <translation>die mittlere Kraft betrug {value}, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>hold tissue with the least force that moves it</source>
        <translation>halten Sie Gewebe mit der kleinsten Kraft, die es bewegt</translation>
    </message>
    <message>
        <source>Force-time product</source>
        <translation>Kraft-Zeit-Produkt</translation>
    </message>
    <message>
        <source>Force integrated over time.</source>
        <translation>Kraft, über die Zeit integriert.</translation>
    </message>
    <message>
        <source>the force-time product was {value}, above the limit of {limit}</source>
        <translation>das Kraft-Zeit-Produkt betrug {value}, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>release tissue that need not be held</source>
        <translation>lassen Sie Gewebe los, das nicht gehalten werden muss</translation>
    </message>
    <message>
        <source>Force peaks</source>
        <translation>Kraftspitzen</translation>
    </message>
    <message>
        <source>Number of times the force peaked above the tissue&apos;s limit.</source>
        <translation>Wie oft eine Kraftspitze über dem Grenzwert des Gewebes lag.</translation>
    </message>
    <message>
        <source>the force exceeded the tissue&apos;s limit {value} times (limit {limit})</source>
        <translation>die Kraft überschritt den Grenzwert des Gewebes {value}-mal (Grenzwert {limit})</translation>
    </message>
    <message>
        <source>move more slowly when tissue is taut</source>
        <translation>bewegen Sie sich langsamer, wenn Gewebe gespannt ist</translation>
    </message>
    <message>
        <source>Steepest force change</source>
        <translation>Steilste Kraftänderung</translation>
    </message>
    <message>
        <source>Fastest rise or fall of the force.</source>
        <translation>Schnellster Anstieg oder Abfall der Kraft.</translation>
    </message>
    <message>
        <source>the force changed by {value}, above the limit of {limit}</source>
        <translation>die Kraft änderte sich mit {value}, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>touch tissue slowly and release it slowly</source>
        <translation>berühren Sie Gewebe langsam und lassen Sie es langsam los</translation>
    </message>
    <message>
        <source>Force volume</source>
        <translation>Kraftvolumen</translation>
    </message>
    <message>
        <source>Volume of the ellipsoid that one standard deviation of the force vector spans.</source>
        <translation>Volumen des Ellipsoids, das eine Standardabweichung des Kraftvektors aufspannt.</translation>
    </message>
    <message>
        <source>the force varied in all directions: volume {value}, above the limit of {limit}</source>
        <translation>die Kraft schwankte in alle Richtungen: Volumen {value}, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>Time above the force limit</source>
        <translation>Zeit über dem Kraftgrenzwert</translation>
    </message>
    <message>
        <source>How long the force was above the tissue&apos;s limit.</source>
        <translation>Wie lange die Kraft über dem Grenzwert des Gewebes lag.</translation>
    </message>
    <message>
        <source>the force exceeded the tissue&apos;s limit for {value} (limit {limit})</source>
        <translation>die Kraft lag {value} lang über dem Grenzwert des Gewebes (Grenzwert {limit})</translation>
    </message>
    <message>
        <source>ease off as soon as the force bar turns</source>
        <translation>lassen Sie nach, sobald der Kraftbalken die Farbe wechselt</translation>
    </message>
    <message>
        <source>Force-time product above the limit</source>
        <translation>Kraft-Zeit-Produkt über dem Grenzwert</translation>
    </message>
    <message>
        <source>The part of the force above the tissue&apos;s limit, added up over time.</source>
        <translation>Der Teil der Kraft über dem Grenzwert des Gewebes, über die Zeit summiert.</translation>
    </message>
    <message>
        <source>the force-time product above the tissue&apos;s limit was {value} (limit {limit})</source>
        <translation>das Kraft-Zeit-Produkt über dem Grenzwert des Gewebes betrug {value} (Grenzwert {limit})</translation>
    </message>
    <message>
        <source>Largest jaw force</source>
        <translation>Größte Maulkraft</translation>
    </message>
    <message>
        <source>Largest force of the jaws on tissue.</source>
        <translation>Größte Kraft des Mauls auf Gewebe.</translation>
    </message>
    <message>
        <source>the jaws pressed with {value}, above the limit of {limit}</source>
        <translation>das Maul drückte mit {value}, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>close only until the tissue no longer slips</source>
        <translation>schließen Sie nur, bis das Gewebe nicht mehr abrutscht</translation>
    </message>
    <message>
        <source>Force-time product of a grasp</source>
        <translation>Kraft-Zeit-Produkt eines Griffs</translation>
    </message>
    <message>
        <source>Jaw force integrated over one grasp, the largest of all grasps. A pause does not end a grasp.</source>
        <translation>Maulkraft, über einen Griff integriert, das größte Ergebnis aller Griffe. Eine Pause beendet einen Griff nicht.</translation>
    </message>
    <message>
        <source>the force-time product of one grasp was {value}, above the limit of {limit}</source>
        <translation>das Kraft-Zeit-Produkt eines Griffs betrug {value}, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>let go and take a new hold from time to time</source>
        <translation>lassen Sie von Zeit zu Zeit los und fassen Sie neu</translation>
    </message>
    <message>
        <source>Force-time product of a patch</source>
        <translation>Kraft-Zeit-Produkt einer Stelle</translation>
    </message>
    <message>
        <source>Jaw force integrated over all grasps of one patch of tissue, the largest of all patches.</source>
        <translation>Maulkraft, über alle Griffe an einer Gewebestelle integriert, das größte Ergebnis aller Stellen.</translation>
    </message>
    <message>
        <source>the force-time product of one patch was {value}, above the limit of {limit}</source>
        <translation>das Kraft-Zeit-Produkt einer Stelle betrug {value}, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>grasp next to the place used before</source>
        <translation>fassen Sie neben der zuvor benutzten Stelle</translation>
    </message>
    <message>
        <source>Largest jaw pressure</source>
        <translation>Größter Mauldruck</translation>
    </message>
    <message>
        <source>Largest jaw force over the area of contact.</source>
        <translation>Größte Maulkraft, bezogen auf die Kontaktfläche.</translation>
    </message>
    <message>
        <source>take a full bite, and avoid holding tissue with the tips</source>
        <translation>fassen Sie mit dem ganzen Maul, und halten Sie Gewebe möglichst nicht mit den Spitzen</translation>
    </message>
    <message>
        <source>Contacts with tissue</source>
        <translation>Gewebekontakte</translation>
    </message>
    <message>
        <source>Number of times the instrument came into contact with tissue.</source>
        <translation>Wie oft das Instrument mit Gewebe in Kontakt kam.</translation>
    </message>
    <message>
        <source>the instrument touched tissue {value} times</source>
        <translation>das Instrument berührte {value}-mal Gewebe</translation>
    </message>
    <message>
        <source>come once and stay</source>
        <translation>setzen Sie einmal an und bleiben Sie dort</translation>
    </message>
    <message>
        <source>Slips</source>
        <translation>Abrutschen</translation>
    </message>
    <message>
        <source>Number of times tissue slipped out of the jaws.</source>
        <translation>Wie oft Gewebe aus dem Maul abgerutscht ist.</translation>
    </message>
    <message>
        <source>tissue slipped {value} times, above the limit of {limit}</source>
        <translation>Gewebe rutschte {value}-mal ab, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>Repeated grasps</source>
        <translation>Wiederholte Griffe</translation>
    </message>
    <message>
        <source>Number of times the same patch was grasped again within 2 s of release.</source>
        <translation>Wie oft dieselbe Stelle innerhalb von 2 s nach dem Loslassen erneut gefasst wurde.</translation>
    </message>
    <message>
        <source>the same place was grasped again {value} times, above the limit of {limit}</source>
        <translation>dieselbe Stelle wurde {value}-mal erneut gefasst, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>Drops</source>
        <translation>Fallen gelassen</translation>
    </message>
    <message>
        <source>Number of objects dropped.</source>
        <translation>Zahl der fallen gelassenen Objekte.</translation>
    </message>
    <message>
        <source>{value} objects were dropped, above the limit of {limit}</source>
        <translation>{value} Objekte wurden fallen gelassen, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>release it only when the object rests</source>
        <translation>lassen Sie das Objekt erst los, wenn es ruhig aufliegt</translation>
    </message>
    <message>
        <source>Perforations</source>
        <translation>Perforationen</translation>
    </message>
    <message>
        <source>Number of perforations.</source>
        <translation>Zahl der Perforationen.</translation>
    </message>
    <message>
        <source>the bowel was perforated {value} times, above the limit of {limit}</source>
        <translation>der Darm wurde {value}-mal perforiert, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>keep the tips in view and never push against resistance</source>
        <translation>behalten Sie die Spitzen im Bild und drücken Sie nie gegen Widerstand</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Time from the first movement or work of either instrument (or of the scope, where there is none) to the end of the task, pauses excluded. In a trace file without events the last sample is the end.</source>
        <translation>Zeit von der ersten Bewegung oder Arbeit eines der Instrumente (oder der Optik, wo es keine gibt) bis zum Ende der Aufgabe, ohne Pausen. In einer Aufzeichnungsdatei ohne Ereignisse ist der letzte Messwert das Ende.</translation>
    </message>
    <message>
        <source>the task took {value}, above the limit of {limit}</source>
        <translation>die Aufgabe dauerte {value}, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>look at the next goal while finishing this one, and keep both hands at work</source>
        <translation>richten Sie den Blick schon auf den nächsten Schritt, während Sie diesen beenden, und lassen Sie beide Hände arbeiten</translation>
    </message>
    <message>
        <source>Path length</source>
        <translation>Weglänge</translation>
    </message>
    <message>
        <source>How far the instrument tip travelled.</source>
        <translation>Wie weit sich die Instrumentenspitze bewegt hat.</translation>
    </message>
    <message>
        <source>the tip travelled {value}, above the limit of {limit}</source>
        <translation>die Spitze legte {value} zurück, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>picture the target&apos;s depth first and go there in one straight move</source>
        <translation>machen Sie sich zuerst ein Bild von der Tiefe des Ziels und gehen Sie dann in einer geraden Bewegung dorthin</translation>
    </message>
    <message>
        <source>Angular path</source>
        <translation>Winkelweg</translation>
    </message>
    <message>
        <source>How much the instrument shaft turned about the trocar.</source>
        <translation>Wie weit sich der Instrumentenschaft um den Trokar gedreht hat.</translation>
    </message>
    <message>
        <source>the shaft turned {value}, above the limit of {limit}</source>
        <translation>der Schaft drehte sich um {value}, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>remember that the tip moves against the hand and steer with small hand movements</source>
        <translation>denken Sie daran, dass sich die Spitze entgegen der Hand bewegt, und steuern Sie mit kleinen Handbewegungen</translation>
    </message>
    <message>
        <source>Economy of movement</source>
        <translation>Bewegungsökonomie</translation>
    </message>
    <message>
        <source>Straight distances between way-points (targets reached, grasps, releases, beginnings and ends of strokes of a blade) over the path that was travelled between them; 1 is a straight line each time. Holds and strokes are left out.</source>
        <translation>Gerade Strecken zwischen Wegpunkten (erreichte Ziele, Griffe, Loslassen, Anfang und Ende der Schnittbewegungen einer Klinge), geteilt durch den dazwischen zurückgelegten Weg; 1 ist jedes Mal eine gerade Linie. Halten und Schnittbewegungen zählen nicht mit.</translation>
    </message>
    <message>
        <source>the path between grasps and targets was indirect: economy {value}, below the required {limit}</source>
        <translation>der Weg zwischen Griffen und Zielen war umständlich: Ökonomie {value}, unter dem geforderten Wert von {limit}</translation>
    </message>
    <message>
        <source>aim before moving, then go straight</source>
        <translation>zielen Sie, bevor Sie sich bewegen, und gehen Sie dann auf geradem Weg</translation>
    </message>
    <message>
        <source>Path while retracting</source>
        <translation>Weg beim Zurückziehen</translation>
    </message>
    <message>
        <source>The part of the path on which the tip moved towards its trocar.</source>
        <translation>Der Teil des Weges, auf dem sich die Spitze zu ihrem Trokar hin bewegte.</translation>
    </message>
    <message>
        <source>the tip moved {value} towards the trocar</source>
        <translation>die Spitze bewegte sich {value} zum Trokar hin</translation>
    </message>
    <message>
        <source>withdraw only as far as the next move needs</source>
        <translation>ziehen Sie nur so weit zurück, wie es die nächste Bewegung braucht</translation>
    </message>
    <message>
        <source>Path while seeking</source>
        <translation>Weg beim Aufsuchen</translation>
    </message>
    <message>
        <source>The part of the path on which the tip moved away from its trocar.</source>
        <translation>Der Teil des Weges, auf dem sich die Spitze von ihrem Trokar weg bewegte.</translation>
    </message>
    <message>
        <source>the tip moved {value} away from the trocar</source>
        <translation>die Spitze bewegte sich {value} vom Trokar weg</translation>
    </message>
    <message>
        <source>judge the depth before going in</source>
        <translation>schätzen Sie die Tiefe ein, bevor Sie hineingehen</translation>
    </message>
    <message>
        <source>Depth travel</source>
        <translation>Weg in der Tiefe</translation>
    </message>
    <message>
        <source>How far the tip travelled along its own shaft, in and out.</source>
        <translation>Wie weit sich die Spitze entlang ihres eigenen Schafts bewegt hat, hinein und heraus.</translation>
    </message>
    <message>
        <source>the tip travelled {value} in and out, above the limit of {limit}</source>
        <translation>die Spitze bewegte sich {value} hinein und heraus, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>read the depth from shadow and parallax before advancing</source>
        <translation>lesen Sie die Tiefe an Schatten und Parallaxe ab, bevor Sie vorschieben</translation>
    </message>
    <message>
        <source>Depth error</source>
        <translation>Tiefenfehler</translation>
    </message>
    <message>
        <source>How far from the target&apos;s surface, too deep or too shallow, the first movement ended, on average over targets.</source>
        <translation>Wie weit von der Oberfläche des Ziels, zu tief oder zu flach, die erste Bewegung endete, im Mittel über die Ziele.</translation>
    </message>
    <message>
        <source>the first movement missed the depth by {value} on average, above the limit of {limit}</source>
        <translation>die erste Bewegung verfehlte die Tiefe im Mittel um {value}, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>slow down near the target and watch the contact shadow</source>
        <translation>werden Sie nahe am Ziel langsamer und achten Sie auf den Kontaktschatten</translation>
    </message>
    <message>
        <source>Depth error, spread</source>
        <translation>Tiefenfehler, Streuung</translation>
    </message>
    <message>
        <source>How much the depth error varied from target to target (standard deviation).</source>
        <translation>Wie sehr der Tiefenfehler von Ziel zu Ziel schwankte (Standardabweichung).</translation>
    </message>
    <message>
        <source>the depth of the first movement varied by {value}, above the limit of {limit}</source>
        <translation>die Tiefe der ersten Bewegung schwankte um {value}, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>use the same cue for depth every time</source>
        <translation>nutzen Sie jedes Mal denselben Hinweis auf die Tiefe</translation>
    </message>
    <message>
        <source>Movements</source>
        <translation>Bewegungen</translation>
    </message>
    <message>
        <source>Number of quick movements: above 50 mm/s for more than 0.2 s.</source>
        <translation>Zahl der schnellen Bewegungen: über 50 mm/s für mehr als 0,2 s.</translation>
    </message>
    <message>
        <source>there were {value} quick movements</source>
        <translation>es gab {value} schnelle Bewegungen</translation>
    </message>
    <message>
        <source>join movements into fewer, larger ones</source>
        <translation>verbinden Sie Bewegungen zu wenigen größeren</translation>
    </message>
    <message>
        <source>Sub-movements</source>
        <translation>Teilbewegungen</translation>
    </message>
    <message>
        <source>Number of corrections: speed peaks within movements.</source>
        <translation>Zahl der Korrekturen: Geschwindigkeitsspitzen innerhalb von Bewegungen.</translation>
    </message>
    <message>
        <source>the movements contained {value} corrections, above the limit of {limit}</source>
        <translation>die Bewegungen enthielten {value} Korrekturen, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>let one movement run out before correcting it</source>
        <translation>lassen Sie eine Bewegung auslaufen, bevor Sie sie korrigieren</translation>
    </message>
    <message>
        <source>Idle time</source>
        <translation>Leerlauf</translation>
    </message>
    <message>
        <source>Share of the time inside the body, from the first movement on, in which the tip stood still and touched nothing.</source>
        <translation>Anteil der Zeit im Körper ab der ersten Bewegung, in der die Spitze stillstand und nichts berührte.</translation>
    </message>
    <message>
        <source>the instrument was idle for {value} of the time, above the limit of {limit}</source>
        <translation>das Instrument war während {value} der Zeit im Leerlauf, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>give the waiting hand a job: hold, expose, or get ready</source>
        <translation>geben Sie der wartenden Hand eine Arbeit: halten, freilegen oder vorbereiten</translation>
    </message>
    <message>
        <source>Mean speed</source>
        <translation>Mittlere Geschwindigkeit</translation>
    </message>
    <message>
        <source>Mean speed of the tip inside the body.</source>
        <translation>Mittlere Geschwindigkeit der Spitze im Körper.</translation>
    </message>
    <message>
        <source>the mean speed was {value}</source>
        <translation>die mittlere Geschwindigkeit betrug {value}</translation>
    </message>
    <message>
        <source>keep an even pace</source>
        <translation>halten Sie ein gleichmäßiges Tempo</translation>
    </message>
    <message>
        <source>Peak speed</source>
        <translation>Höchstgeschwindigkeit</translation>
    </message>
    <message>
        <source>Highest speed of the tip inside the body.</source>
        <translation>Höchste Geschwindigkeit der Spitze im Körper.</translation>
    </message>
    <message>
        <source>the peak speed was {value}</source>
        <translation>die Höchstgeschwindigkeit betrug {value}</translation>
    </message>
    <message>
        <source>avoid sudden moves</source>
        <translation>vermeiden Sie plötzliche Bewegungen</translation>
    </message>
    <message>
        <source>Working volume</source>
        <translation>Arbeitsvolumen</translation>
    </message>
    <message>
        <source>Volume of the ellipsoid that holds 95 % of the tip&apos;s positions.</source>
        <translation>Volumen des Ellipsoids, das 95 % der Positionen der Spitze enthält.</translation>
    </message>
    <message>
        <source>the working volume was {value}, above the limit of {limit}</source>
        <translation>das Arbeitsvolumen betrug {value}, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>keep the tips close to where the work is</source>
        <translation>halten Sie die Spitzen nahe am Ort der Arbeit</translation>
    </message>
    <message>
        <source>Off screen</source>
        <translation>Nicht im Bild</translation>
    </message>
    <message>
        <source>Share of the time inside the body, from the first movement on, in which the tip was outside the image.</source>
        <translation>Anteil der Zeit im Körper ab der ersten Bewegung, in der die Spitze außerhalb des Bildes war.</translation>
    </message>
    <message>
        <source>the tip was out of sight for {value} of the time, above the limit of {limit}</source>
        <translation>die Spitze war während {value} der Zeit nicht zu sehen, über dem Grenzwert von {limit}</translation>
    </message>
    <message>
        <source>move the camera first, then the instrument</source>
        <translation>bewegen Sie zuerst die Kamera, dann das Instrument</translation>
    </message>
    <message>
        <source>Smoothness (SPARC)</source>
        <translation>Bewegungsruhe (SPARC)</translation>
    </message>
    <message>
        <source>Spectral arc length of tip speed, median over movements in which the instrument neither holds nor cuts tissue. Nearer to 0 is smoother; a single smooth reach has about -1.4.</source>
        <translation>Spektrale Bogenlänge der Geschwindigkeit der Spitze, Median über die Bewegungen, in denen das Instrument Gewebe weder hält noch schneidet. Näher an 0 ist ruhiger; eine einzelne ruhige Bewegung zum Ziel hat etwa -1,4.</translation>
    </message>
    <message>
        <source>movements were made of many corrections: smoothness {value}, below the required {limit}</source>
        <translation>Bewegungen bestanden aus vielen Korrekturen: Bewegungsruhe {value}, unter dem geforderten Wert {limit}</translation>
    </message>
    <message>
        <source>start each move slowly and let it run out in one stroke</source>
        <translation>beginnen Sie jede Bewegung langsam und lassen Sie sie in einem Zug auslaufen</translation>
    </message>
    <message>
        <source>Smoothness (log jerk)</source>
        <translation>Bewegungsruhe (log. Ruck)</translation>
    </message>
    <message>
        <source>Minus the logarithm of the dimensionless jerk of tip speed, median over movements in which the instrument neither holds nor cuts tissue. Nearer to 0 is smoother; absent where the device&apos;s position noise would decide it.</source>
        <translation>Negativer Logarithmus des dimensionslosen Rucks aus der Geschwindigkeit der Spitze, Median über Bewegungen, in denen das Instrument Gewebe weder hält noch schneidet. Näher an 0 ist ruhiger; entfällt, wo das Positionsrauschen des Geräts den Wert bestimmen würde.</translation>
    </message>
    <message>
        <source>movements were jerky: log jerk {value}, below the required {limit}</source>
        <translation>Bewegungen waren ruckartig: log. Ruck {value}, unter dem geforderten Wert {limit}</translation>
    </message>
    <message>
        <source>relax the grip and accelerate gently</source>
        <translation>lockern Sie den Griff und beschleunigen Sie sanft</translation>
    </message>
    <message>
        <source>Tremor share</source>
        <translation>Tremoranteil</translation>
    </message>
    <message>
        <source>Share of the tip&apos;s acceleration that is in the tremor band of 6 to 12 Hz.</source>
        <translation>Anteil der Beschleunigung der Spitze, der im Tremorbereich von 6 bis 12 Hz liegt.</translation>
    </message>
    <message>
        <source>tremor made up {value} of the acceleration, above the limit of {limit}</source>
        <translation>Tremor machte {value} der Beschleunigung aus, über dem Grenzwert {limit}</translation>
    </message>
    <message>
        <source>rest the forearms and hold the handles loosely</source>
        <translation>legen Sie die Unterarme auf und halten Sie die Griffe locker</translation>
    </message>
    <message>
        <source>Force smoothness (SPARC)</source>
        <translation>Gleichmaß der Kraft (SPARC)</translation>
    </message>
    <message>
        <source>Spectral arc length of the rate at which the force on tissue changed, median over movements in contact.</source>
        <translation>Spektrale Bogenlänge der Rate, mit der sich die Kraft auf das Gewebe änderte, Median über Bewegungen mit Kontakt.</translation>
    </message>
    <message>
        <source>force was applied in bursts: force smoothness {value}, below the required {limit}</source>
        <translation>Kraft wurde stoßweise ausgeübt: Gleichmaß der Kraft {value}, unter dem geforderten Wert {limit}</translation>
    </message>
    <message>
        <source>take up the tension slowly and keep it</source>
        <translation>bauen Sie die Spannung langsam auf und halten Sie sie</translation>
    </message>
    <message>
        <source>Mesorectal grade</source>
        <translation>Grad des Mesorektums</translation>
    </message>
    <message>
        <source>Grade that a pathologist would give the specimen: 3 complete, 2 nearly complete, 1 incomplete.</source>
        <translation>Grad, den ein Pathologe dem Präparat geben würde: 3 vollständig, 2 nahezu vollständig, 1 unvollständig.</translation>
    </message>
    <message>
        <source>the specimen is of grade {value}, below the required {limit}</source>
        <translation>das Präparat hat Grad {value}, unter dem geforderten Wert {limit}</translation>
    </message>
    <message>
        <source>stay on the shiny surface of the mesorectum and stop as soon as fat shows in front of the blade</source>
        <translation>bleiben Sie auf der glänzenden Oberfläche des Mesorektums und halten Sie an, sobald vor der Klinge Fett erscheint</translation>
    </message>
    <message>
        <source>Deepest defect of the mesorectum</source>
        <translation>Tiefster Defekt des Mesorektums</translation>
    </message>
    <message>
        <source>How deep the cut went into the fat that should stay intact.</source>
        <translation>Wie tief der Schnitt in das Fett ging, das unversehrt bleiben soll.</translation>
    </message>
    <message>
        <source>the cut went {value} into the fat, above the limit of {limit}</source>
        <translation>der Schnitt ging {value} tief ins Fett, über dem Grenzwert {limit}</translation>
    </message>
    <message>
        <source>keep the blade in the white fibres; where you see yellow you are too close to the rectum</source>
        <translation>halten Sie die Klinge in den weißen Fasern; wo Sie Gelb sehen, sind Sie zu nah am Rektum</translation>
    </message>
    <message>
        <source>Circumferential margin</source>
        <translation>Zirkumf. Rand (CRM)</translation>
    </message>
    <message>
        <source>Least distance between the cut and the edge of the tumour. At 1 mm or less the margin is positive.</source>
        <translation>Kleinster Abstand zwischen Schnitt und Tumorrand. Bei 1 mm oder weniger ist der CRM positiv.</translation>
    </message>
    <message>
        <source>the cut passed the tumour at {value}, below the required {limit}</source>
        <translation>der Schnitt lief mit {value} Abstand am Tumor vorbei, unter dem geforderten Wert {limit}</translation>
    </message>
    <message>
        <source>know where the tumour is and keep to the plane next to it</source>
        <translation>machen Sie sich klar, wo der Tumor liegt, und bleiben Sie in der Schicht neben ihm</translation>
    </message>
    <message>
        <source>Distal reach below the tumour</source>
        <translation>Distale Strecke unter dem Tumor</translation>
    </message>
    <message>
        <source>How far below the tumour the dissection reached: the distal margin that a transection there would leave.</source>
        <translation>Wie weit die Dissektion unter den Tumor reichte: der distale Absetzungsrand, den ein Absetzen dort ergäbe.</translation>
    </message>
    <message>
        <source>the dissection reached {value} below the tumour, below the required {limit}</source>
        <translation>die Dissektion reichte {value} unter den Tumor, unter dem geforderten Wert {limit}</translation>
    </message>
    <message>
        <source>divide every level from side to side before you go deeper, down to the levator</source>
        <translation>durchtrennen Sie jede Etage von Seite zu Seite, bevor Sie tiefer gehen, bis hinab zum Levator</translation>
    </message>
    <message>
        <source>Distance from the plane, right</source>
        <translation>Abstand zur Schicht, rechts</translation>
    </message>
    <message>
        <source>Distance of the cut from the intended plane on the patient&apos;s right, whichever side: half of the cut is nearer.</source>
        <translation>Abstand des Schnitts von der vorgesehenen Schicht auf der rechten Seite des Patienten, gleich in welche Richtung: Die Hälfte des Schnitts liegt näher.</translation>
    </message>
    <message>
        <source>on the patient&apos;s right half of the cut lay further than {value} from the plane, above the limit of {limit}</source>
        <translation>auf der rechten Seite des Patienten lag die Hälfte des Schnitts weiter als {value} von der Schicht entfernt, über dem Grenzwert {limit}</translation>
    </message>
    <message>
        <source>restore the tension on the patient&apos;s right before you cut there</source>
        <translation>stellen Sie auf der rechten Seite des Patienten die Spannung wieder her, bevor Sie dort schneiden</translation>
    </message>
    <message>
        <source>Distance from the plane, midline</source>
        <translation>Abstand zur Schicht, Mittellinie</translation>
    </message>
    <message>
        <source>Distance of the cut from the intended plane in the midline, whichever side: half of the cut is nearer.</source>
        <translation>Abstand des Schnitts von der vorgesehenen Schicht in der Mittellinie, gleich in welche Richtung: Die Hälfte des Schnitts liegt näher.</translation>
    </message>
    <message>
        <source>in the midline half of the cut lay further than {value} from the plane, above the limit of {limit}</source>
        <translation>in der Mittellinie lag die Hälfte des Schnitts weiter als {value} von der Schicht entfernt, über dem Grenzwert {limit}</translation>
    </message>
    <message>
        <source>restore the tension in the midline before you cut there</source>
        <translation>stellen Sie in der Mittellinie die Spannung wieder her, bevor Sie dort schneiden</translation>
    </message>
    <message>
        <source>Distance from the plane, left</source>
        <translation>Abstand zur Schicht, links</translation>
    </message>
    <message>
        <source>Distance of the cut from the intended plane on the patient&apos;s left, whichever side: half of the cut is nearer.</source>
        <translation>Abstand des Schnitts von der vorgesehenen Schicht auf der linken Seite des Patienten, gleich in welche Richtung: Die Hälfte des Schnitts liegt näher.</translation>
    </message>
    <message>
        <source>on the patient&apos;s left half of the cut lay further than {value} from the plane, above the limit of {limit}</source>
        <translation>auf der linken Seite des Patienten lag die Hälfte des Schnitts weiter als {value} von der Schicht entfernt, über dem Grenzwert {limit}</translation>
    </message>
    <message>
        <source>restore the tension on the patient&apos;s left before you cut there</source>
        <translation>stellen Sie auf der linken Seite des Patienten die Spannung wieder her, bevor Sie dort schneiden</translation>
    </message>
    <message>
        <source>apply traction until the plane opens, and follow the middle of the stretched fibres</source>
        <translation>ziehen Sie, bis sich die Schicht öffnet, und folgen Sie der Mitte der gespannten Fasern</translation>
    </message>
    <message>
        <source>apply less traction, and go back along the line and divide the bridges that are left</source>
        <translation>ziehen Sie weniger, gehen Sie die Linie noch einmal ab und durchtrennen Sie die verbliebenen Brücken</translation>
    </message>
    <message>
        <source>clip or seal a vessel before it is divided, and apply less traction</source>
        <translation>clippen oder versiegeln Sie ein Gefäß, bevor es durchtrennt wird, und ziehen Sie weniger</translation>
    </message>
    <message>
        <source>approach slowly, and stop when the tissue no longer yields</source>
        <translation>nähern Sie sich langsam, und ziehen Sie nicht weiter, wenn das Gewebe nicht mehr nachgibt</translation>
    </message>
    <message>
        <source>decide on one direction of traction and keep it</source>
        <translation>entscheiden Sie sich für eine Zugrichtung und behalten Sie sie bei</translation>
    </message>
    <message>
        <source>take a larger bite before you apply traction</source>
        <translation>fassen Sie mehr Gewebe, bevor Sie ziehen</translation>
    </message>
    <message>
        <source>place the jaws where you will apply traction, then close once</source>
        <translation>setzen Sie das Maul dort an, wo Sie ziehen werden, und schließen Sie es dann einmal</translation>
    </message>
</context>
<context>
    <name>fulcrum::operators</name>
    <message>
        <source>expert</source>
        <translation>Experte</translation>
    </message>
    <message>
        <source>intermediate</source>
        <translation>Fortgeschrittener</translation>
    </message>
    <message>
        <source>novice</source>
        <translation>Anfänger</translation>
    </message>
</context>
<context>
    <name>fulcrum::people</name>
    <message>
        <source>real</source>
        <translation>echt</translation>
    </message>
    <message>
        <source>synthetic</source>
        <translation>synthetisch</translation>
    </message>
    <message>
        <source>external</source>
        <translation>extern</translation>
    </message>
</context>
<context>
    <name>fulcrum::standings</name>
    <message>
        <source>locked</source>
        <translation>gesperrt</translation>
    </message>
    <message>
        <source>open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>attempted</source>
        <translation>begonnen</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>proficient</source>
        <translation>sicher beherrscht</translation>
    </message>
    <message>
        <source>maintained</source>
        <translation>gehalten</translation>
    </message>
    <message>
        <source>check due</source>
        <translation>Kontrolle fällig</translation>
    </message>
    <message>
        <source>relapsed</source>
        <translation>zurückgefallen</translation>
    </message>
    <message>
        <source>awaiting rating</source>
        <translation>Beurteilung steht aus</translation>
    </message>
</context>
<context>
    <name>fulcrum::statements</name>
    <message>
        <source>{text}</source>
        <translation>{text}</translation>
    </message>
    <message>
        <source>no instrument moved faster than 5 mm/s for 0.2 s inside the body</source>
        <translation>kein Instrument bewegte sich im Körper 0,2 s lang schneller als 5 mm/s</translation>
    </message>
    <message>
        <source>the instrument never moved faster than 5 mm/s for 0.2 s inside the body</source>
        <translation>das Instrument bewegte sich im Körper nie 0,2 s lang schneller als 5 mm/s</translation>
    </message>
    <message>
        <source>fewer than {least} way-points (targets reached, grasps, releases)</source>
        <translation>weniger als {least} Wegpunkte (erreichte Ziele, Fassen, Loslassen)</translation>
    </message>
    <message>
        <source>the instrument did not move between way-points</source>
        <translation>das Instrument bewegte sich zwischen den Wegpunkten nicht</translation>
    </message>
    <message>
        <source>the positions of targets are not known</source>
        <translation>die Positionen der Ziele sind nicht bekannt</translation>
    </message>
    <message>
        <source>no target was shown to this hand</source>
        <translation>für diese Hand wurde kein Ziel gezeigt</translation>
    </message>
    <message>
        <source>no target was held</source>
        <translation>es wurde kein Ziel gehalten</translation>
    </message>
    <message>
        <source>the moving tip was never found</source>
        <translation>die bewegte Spitze wurde nie gefunden</translation>
    </message>
    <message>
        <source>fewer than {least} movements towards a target</source>
        <translation>weniger als {least} Bewegungen zu einem Ziel hin</translation>
    </message>
    <message>
        <source>no movement between two rests</source>
        <translation>keine Bewegung zwischen zwei Ruhephasen</translation>
    </message>
    <message>
        <source>the instrument was never inside the body</source>
        <translation>das Instrument war nie im Körper</translation>
    </message>
    <message>
        <source>the tip did not move in three dimensions</source>
        <translation>die Spitze bewegte sich nicht in drei Dimensionen</translation>
    </message>
    <message>
        <source>the task leaves no specimen</source>
        <translation>die Aufgabe ergibt kein Präparat</translation>
    </message>
    <message>
        <source>nothing was cut</source>
        <translation>es wurde nichts geschnitten</translation>
    </message>
    <message>
        <source>{percent} % of the plane was divided; a grade needs {least} %</source>
        <translation>{percent} % der Schicht wurden durchtrennt; für einen Grad sind {least} % nötig</translation>
    </message>
    <message>
        <source>the case has no tumour</source>
        <translation>der Fall hat keinen Tumor</translation>
    </message>
    <message>
        <source>the plane next to the tumour was not divided</source>
        <translation>die Schicht neben dem Tumor wurde nicht durchtrennt</translation>
    </message>
    <message>
        <source>the dissection did not reach beyond the tumour</source>
        <translation>die Dissektion reichte nicht über den Tumor hinaus</translation>
    </message>
    <message>
        <source>nothing was cut in this sector</source>
        <translation>in diesem Sektor wurde nichts geschnitten</translation>
    </message>
    <message>
        <source>the task marks no line to cut along</source>
        <translation>die Aufgabe gibt keine Schnittlinie vor</translation>
    </message>
    <message>
        <source>the traction of the cut was not recorded</source>
        <translation>der Zug beim Schnitt wurde nicht aufgezeichnet</translation>
    </message>
    <message>
        <source>the task sets no range of traction</source>
        <translation>die Aufgabe gibt keinen Bereich für den Zug vor</translation>
    </message>
    <message>
        <source>the task&apos;s line has no length</source>
        <translation>die Linie der Aufgabe hat keine Länge</translation>
    </message>
    <message>
        <source>energy was never activated</source>
        <translation>Strom wurde nie aktiviert</translation>
    </message>
    <message>
        <source>nothing was recorded</source>
        <translation>es wurde nichts aufgezeichnet</translation>
    </message>
    <message>
        <source>{count} movements, fewer than {least}</source>
        <translation>{count} Bewegungen, weniger als {least}</translation>
    </message>
    <message>
        <source>{count} movements with force on tissue, fewer than {least}</source>
        <translation>{count} Bewegungen mit Kraft auf Gewebe, weniger als {least}</translation>
    </message>
    <message>
        <source>movements between two rests hold less than half of the moving time</source>
        <translation>auf Bewegungen zwischen zwei Ruhephasen entfällt weniger als die Hälfte der Bewegungszeit</translation>
    </message>
    <message>
        <source>the device&apos;s position noise at rest is {noise_um} µm, above {limit_um} µm</source>
        <translation>das Positionsrauschen des Geräts in Ruhe beträgt {noise_um} µm, mehr als {limit_um} µm</translation>
    </message>
    <message>
        <source>less than {least_s} s with the instrument inside the body</source>
        <translation>weniger als {least_s} s mit dem Instrument im Körper</translation>
    </message>
    <message>
        <source>the instrument did not move</source>
        <translation>das Instrument bewegte sich nicht</translation>
    </message>
    <message>
        <source>no instrument moved</source>
        <translation>kein Instrument bewegte sich</translation>
    </message>
    <message>
        <source>one of the instruments did not move while both were inside</source>
        <translation>eines der Instrumente bewegte sich nicht, während beide im Körper waren</translation>
    </message>
    <message>
        <source>no instrument was inside the body</source>
        <translation>kein Instrument war im Körper</translation>
    </message>
    <message>
        <source>there was no force on tissue</source>
        <translation>auf Gewebe wirkte keine Kraft</translation>
    </message>
    <message>
        <source>there was no force on {tissue}</source>
        <translation>auf dieses Gewebe wirkte keine Kraft: {tissue}</translation>
    </message>
    <message>
        <source>no force limit is known for any tissue</source>
        <translation>für kein Gewebe ist ein Grenzwert der Kraft bekannt</translation>
    </message>
    <message>
        <source>no force limit is known for {tissue}</source>
        <translation>für dieses Gewebe ist kein Grenzwert der Kraft bekannt: {tissue}</translation>
    </message>
    <message>
        <source>less than {least_s} s with force on tissue</source>
        <translation>weniger als {least_s} s mit Kraft auf Gewebe</translation>
    </message>
    <message>
        <source>nothing was grasped</source>
        <translation>es wurde nichts gefasst</translation>
    </message>
    <message>
        <source>the record&apos;s numbers are too large for it</source>
        <translation>die Zahlen der Aufzeichnung sind dafür zu groß</translation>
    </message>
    <message>
        <source>the record carries no events</source>
        <translation>die Aufzeichnung enthält keine Ereignisse</translation>
    </message>
    <message>
        <source>fewer than two consecutive samples</source>
        <translation>weniger als zwei aufeinanderfolgende Messpunkte</translation>
    </message>
    <message>
        <source>the mean rate of {rate_hz} Hz is below {least_hz} Hz</source>
        <translation>die mittlere Rate von {rate_hz} Hz liegt unter {least_hz} Hz</translation>
    </message>
    <message>
        <source>{count} samples were lost</source>
        <translation>{count} Messpunkte gingen verloren</translation>
    </message>
    <message>
        <source>not recorded: {channels}</source>
        <translation>nicht aufgezeichnet: {channels}</translation>
    </message>
    <message>
        <source>the metric was not computed</source>
        <translation>die Kennzahl wurde nicht berechnet</translation>
    </message>
    <message>
        <source>the program does not know the metric</source>
        <translation>das Programm kennt die Kennzahl nicht</translation>
    </message>
    <message>
        <source>there is no benchmark for this task and device class</source>
        <translation>für diese Aufgabe und Geräteklasse gibt es keine Richtwerte</translation>
    </message>
    <message>
        <source>the benchmark set has no level for it</source>
        <translation>der Richtwertsatz enthält dafür keinen Wert</translation>
    </message>
    <message>
        <source>not comparable: cutting parameters differ from those of the benchmark&apos;s scene ({difference})</source>
        <translation>nicht vergleichbar: die Schneideparameter weichen von denen der Richtwert-Szene ab ({difference})</translation>
    </message>
    <message>
        <source>not comparable: there are no limits for this device class ({device})</source>
        <translation>nicht vergleichbar: für diese Geräteklasse gibt es keine Grenzwerte ({device})</translation>
    </message>
    <message>
        <source>not comparable: the limits are for fidelity {limits}, the attempt used {used}</source>
        <translation>nicht vergleichbar: die Grenzwerte gelten für Genauigkeit {limits}, der Versuch lief mit {used}</translation>
    </message>
    <message>
        <source>not comparable: the limits are for variant {limits}, the attempt used {used}</source>
        <translation>nicht vergleichbar: die Grenzwerte gelten für Variante {limits}, der Versuch lief mit {used}</translation>
    </message>
    <message>
        <source>not comparable: the limits in force when the attempt began have been replaced</source>
        <translation>nicht vergleichbar: die Grenzwerte, die bei Beginn des Versuchs galten, wurden ersetzt</translation>
    </message>
    <message>
        <source>the simulator failed during the attempt</source>
        <translation>der Simulator ist während des Versuchs ausgefallen</translation>
    </message>
    <message>
        <source>the attempt was interrupted</source>
        <translation>der Versuch wurde unterbrochen</translation>
    </message>
    <message>
        <source>the attempt ended before the first movement</source>
        <translation>der Versuch endete vor der ersten Bewegung</translation>
    </message>
    <message>
        <source>a device was lost and came back: what followed is practice</source>
        <translation>ein Gerät fiel aus und kam zurück: was folgte, ist Übung</translation>
    </message>
    <message>
        <source>the task has no gates</source>
        <translation>die Aufgabe hat keine Kriterien</translation>
    </message>
    <message>
        <source>{metric}{of_hand}: {because}</source>
        <translation>{metric}{of_hand}: {because}</translation>
    </message>
    <message>
        <source>{where}critical error, {event}{in_tissue} at {time}; {remedy}.</source>
        <translation>{where}kritischer Fehler, {event}{in_tissue} bei {time}; {remedy}.</translation>
    </message>
    <message>
        <source>{where}{fault} ({excess}){on_tissue}; {remedy}.</source>
        <translation>{where}{fault} ({excess}){on_tissue}; {remedy}.</translation>
    </message>
    <message>
        <source>{where}{metric} has no value because {because}; {remedy}.</source>
        <translation>{where}{metric} ohne Wert: {because}; {remedy}.</translation>
    </message>
    <message>
        <source>Not scored: {because}.</source>
        <translation>Nicht bewertet: {because}.</translation>
    </message>
    <message>
        <source>.</source>
        <translation>,</translation>
    </message>
    <message>
        <source>, {hand}</source>
        <translation>, {hand}</translation>
    </message>
    <message>
        <source> ({tissue})</source>
        <translation> ({tissue})</translation>
    </message>
    <message>
        <source>, on {tissue}</source>
        <translation>, Gewebe: {tissue}</translation>
    </message>
    <message>
        <source>left hand</source>
        <translation>linke Hand</translation>
    </message>
    <message>
        <source>right hand</source>
        <translation>rechte Hand</translation>
    </message>
    <message>
        <source>{hand}, in &apos;{phase}&apos;: </source>
        <translation>{hand}, in „{phase}“: </translation>
    </message>
    <message>
        <source>{hand}: </source>
        <translation>{hand}: </translation>
    </message>
    <message>
        <source>in &apos;{phase}&apos;: </source>
        <translation>in „{phase}“: </translation>
    </message>
    <message>
        <source>{metric} is {value}, the limit is {limit}</source>
        <translation>{metric} ist {value}, der Grenzwert ist {limit}</translation>
    </message>
    <message>
        <source>replay that moment and plan it differently</source>
        <translation>sehen Sie sich diese Stelle in der Wiedergabe an und planen Sie sie anders</translation>
    </message>
    <message>
        <source>far outside</source>
        <translation>weit außerhalb</translation>
    </message>
    <message>
        <source>{amount} standard deviations from the experts</source>
        <translation>{amount} Standardabweichungen von den Experten entfernt</translation>
    </message>
    <message>
        <source>less than 1 % over</source>
        <translation>weniger als 1 % darüber</translation>
    </message>
    <message>
        <source>{amount} % over</source>
        <translation>{amount} % darüber</translation>
    </message>
    <message>
        <source>{amount} short</source>
        <translation>{amount} darunter</translation>
    </message>
    <message>
        <source>{amount} over</source>
        <translation>{amount} darüber</translation>
    </message>
    <message>
        <source>it was recorded elsewhere and imported: measured, but judged by no limits</source>
        <translation>anderswo aufgezeichnet und importiert: gemessen, aber nach keinen Grenzwerten bewertet</translation>
    </message>
    <message>
        <source>a device was lost and came back</source>
        <translation>ein Gerät ging verloren und kam zurück</translation>
    </message>
    <message>
        <source>the program stood still for {seconds} s</source>
        <translation>das Programm stand {seconds} s still</translation>
    </message>
    <message>
        <source>All gates are met. Repeat the task to make it a habit.</source>
        <translation>Alle Kriterien sind erfüllt. Wiederholen Sie die Aufgabe, bis sie zur Gewohnheit wird.</translation>
    </message>
    <message>
        <source>All gates are met. Closest to its limit: {metric}{of_hand} ({value}, limit {limit}). To improve: {remedy}.</source>
        <translation>Alle Kriterien sind erfüllt. Am knappsten: {metric}{of_hand} ({value}, Grenzwert {limit}). Zur Verbesserung: {remedy}.</translation>
    </message>
    <message>
        <source>The time ran out before the last step was completed. To improve: {remedy}.</source>
        <translation>Die Zeit lief ab, bevor der letzte Schritt abgeschlossen war. Zur Verbesserung: {remedy}.</translation>
    </message>
    <message>
        <source>The attempt was abandoned before the last step was completed. Carry the next one through to the end.</source>
        <translation>Der Versuch wurde abgebrochen, bevor der letzte Schritt abgeschlossen war. Führen Sie den nächsten bis zum Ende durch.</translation>
    </message>
    <message>
        <source>not comparable: the limits in force were made with another version of the metric &apos;{metric}&apos;; they have to be built again</source>
        <translation>nicht vergleichbar: die geltenden Grenzwerte wurden mit einer anderen Version der Kennzahl „{metric}“ erstellt; sie müssen neu erstellt werden</translation>
    </message>
</context>
<context>
    <name>fulcrum::taught_lines</name>
    <message>
        <source>Mouse	moves the handle of the active hand; the tip goes the other way</source>
        <translation>Maus	bewegt den Griff der aktiven Hand; die Spitze geht in die Gegenrichtung</translation>
    </message>
    <message>
        <source>{second}, {other}	the other hand</source>
        <translation>{second}, {other}	die andere Hand</translation>
    </message>
    <message>
        <source>Wheel	in and out</source>
        <translation>Rad	hinein und heraus</translation>
    </message>
    <message>
        <source>Shift + mouse	turns the shaft</source>
        <translation>Umschalt + Maus	dreht den Schaft</translation>
    </message>
    <message>
        <source>{first} · {jaws}	closes the jaws while held · they stay closed, or open again</source>
        <translation>{first} · {jaws}	schließt das Maul, solange gedrückt · es bleibt zu oder öffnet wieder</translation>
    </message>
    <message>
        <source>{pedal}	pedal of the active hand (energy, suction)</source>
        <translation>{pedal}	Pedal der aktiven Hand (Energie, Sauger)</translation>
    </message>
    <message>
        <source>{exchange}	next instrument of the active hand</source>
        <translation>{exchange}	nächstes Instrument der aktiven Hand</translation>
    </message>
    <message>
        <source>{look} · {in}	scope: look · in, out</source>
        <translation>{look} · {in}	Optik: sehen · hinein, heraus</translation>
    </message>
    <message>
        <source>Mouse	moves the handle of the scope; the lens goes the other way</source>
        <translation>Maus	bewegt den Griff der Optik; die Linse geht in die Gegenrichtung</translation>
    </message>
    <message>
        <source>Shift + mouse	turns the light post: the direction in which the scope looks</source>
        <translation>Umschalt + Maus	dreht den Lichtanschluss: die Blickrichtung der Optik</translation>
    </message>
    <message>
        <source>Ctrl + mouse	turns the camera head: the image alone</source>
        <translation>Strg + Maus	dreht den Kamerakopf: nur das Bild</translation>
    </message>
    <message>
        <source>Each mouse	moves the handle of its hand; the tip goes the other way</source>
        <translation>Jede Maus	bewegt den Griff ihrer Hand; die Spitze geht in die Gegenrichtung</translation>
    </message>
    <message>
        <source>Wheel, or right button + mouse	in and out</source>
        <translation>Rad, oder rechte Taste + Maus	hinein und heraus</translation>
    </message>
    <message>
        <source>Right button + mouse sideways	turns the shaft</source>
        <translation>Rechte Taste + Maus seitwärts	dreht den Schaft</translation>
    </message>
    <message>
        <source>Left button	closes the jaws of that hand while held</source>
        <translation>Linke Taste	schließt das Maul dieser Hand, solange gedrückt</translation>
    </message>
    <message>
        <source>Middle button	pedal of that hand (energy, suction)</source>
        <translation>Mittlere Taste	Pedal dieser Hand (Energie, Sauger)</translation>
    </message>
    <message>
        <source>Side button	next instrument of that hand</source>
        <translation>Seitentaste	nächstes Instrument dieser Hand</translation>
    </message>
    <message>
        <source>Right mouse	moves the handle of the scope; the lens goes the other way</source>
        <translation>Rechte Maus	bewegt den Griff der Optik; die Linse geht in die Gegenrichtung</translation>
    </message>
    <message>
        <source>Right button + mouse sideways	turns the light post: the direction in which the scope looks</source>
        <translation>Rechte Taste + Maus seitwärts	dreht den Lichtanschluss: die Blickrichtung der Optik</translation>
    </message>
    <message>
        <source>{head}	turns the camera head: the image alone</source>
        <translation>{head}	dreht den Kamerakopf: nur das Bild</translation>
    </message>
    <message>
        <source>Each stick	moves the handle of its hand; the tip goes the other way</source>
        <translation>Jeder Stick	bewegt den Griff seiner Hand; die Spitze geht in die Gegenrichtung</translation>
    </message>
    <message>
        <source>Shoulder button + stick up, down	in and out</source>
        <translation>Schultertaste + Stick auf, ab	hinein und heraus</translation>
    </message>
    <message>
        <source>Shoulder button + stick sideways	turns the shaft</source>
        <translation>Schultertaste + Stick seitwärts	dreht den Schaft</translation>
    </message>
    <message>
        <source>Trigger · press on a stick	closes the jaws · they stay closed, or open again</source>
        <translation>Abzug · Druck auf einen Stick	schließt das Maul · es bleibt zu oder öffnet wieder</translation>
    </message>
    <message>
        <source>Left, right button	pedal of that hand (energy, suction)</source>
        <translation>Linke, rechte Taste	Pedal dieser Hand (Energie, Sauger)</translation>
    </message>
    <message>
        <source>Lower button	next instrument of the hand that worked last</source>
        <translation>Untere Taste	nächstes Instrument der Hand, die zuletzt gearbeitet hat</translation>
    </message>
    <message>
        <source>Direction pad · upper button + pad	scope: look · in, out</source>
        <translation>Steuerkreuz · obere Taste + Steuerkreuz	Optik: sehen · hinein, heraus</translation>
    </message>
    <message>
        <source>Left stick	moves the handle of the scope; the lens goes the other way</source>
        <translation>Linker Stick	bewegt den Griff der Optik; die Linse geht in die Gegenrichtung</translation>
    </message>
    <message>
        <source>Left shoulder button + left stick	in and out</source>
        <translation>Linke Schultertaste + linker Stick	hinein und heraus</translation>
    </message>
    <message>
        <source>Right stick	turns the light post: the direction in which the scope looks</source>
        <translation>Rechter Stick	dreht den Lichtanschluss: die Blickrichtung der Optik</translation>
    </message>
    <message>
        <source>Right shoulder button + right stick	turns the camera head: the image alone</source>
        <translation>Rechte Schultertaste + rechter Stick	dreht den Kamerakopf: nur das Bild</translation>
    </message>
    <message>
        <source>Script of the device	moves the handle of a hand; the tip goes the other way</source>
        <translation>Skript des Geräts	bewegt den Griff einer Hand; die Spitze geht in die Gegenrichtung</translation>
    </message>
    <message>
        <source>Script of the device	in and out</source>
        <translation>Skript des Geräts	hinein und heraus</translation>
    </message>
    <message>
        <source>Script, or {turn}	turns the shaft</source>
        <translation>Skript, oder {turn}	dreht den Schaft</translation>
    </message>
    <message>
        <source>Script, or {each_jaws}	closes the jaws</source>
        <translation>Skript, oder {each_jaws}	schließt das Maul</translation>
    </message>
    <message>
        <source>Script, or {pedal}	pedal (energy, suction)</source>
        <translation>Skript, oder {pedal}	Pedal (Energie, Sauger)</translation>
    </message>
    <message>
        <source>Script, or {exchange}	next instrument</source>
        <translation>Skript, oder {exchange}	nächstes Instrument</translation>
    </message>
    <message>
        <source>Script of the device	scope: look · in, out</source>
        <translation>Skript des Geräts	Optik: sehen · hinein, heraus</translation>
    </message>
    <message>
        <source>Script of the device	moves the handle of the scope; the lens goes the other way</source>
        <translation>Skript des Geräts	bewegt den Griff der Optik; die Linse geht in die Gegenrichtung</translation>
    </message>
    <message>
        <source>Script, or {post}	turns the light post: the direction in which the scope looks</source>
        <translation>Skript, oder {post}	dreht den Lichtanschluss: die Blickrichtung der Optik</translation>
    </message>
    <message>
        <source>Stylus	is the handle of its hand; the tip goes the other way</source>
        <translation>Stift	ist der Griff seiner Hand; die Spitze geht in die Gegenrichtung</translation>
    </message>
    <message>
        <source>Stylus away from you, towards you	in, out</source>
        <translation>Stift von Ihnen weg, zu Ihnen hin	hinein, heraus</translation>
    </message>
    <message>
        <source>Turn the stylus between your fingers	turns the shaft</source>
        <translation>Stift zwischen den Fingern drehen	dreht den Schaft</translation>
    </message>
    <message>
        <source>Front button of the stylus	closes the jaws while held</source>
        <translation>Vordere Taste des Stifts	schließt das Maul, solange gedrückt</translation>
    </message>
    <message>
        <source>Rear button of the stylus	pedal of that hand (energy, suction)</source>
        <translation>Hintere Taste des Stifts	Pedal dieser Hand (Energie, Sauger)</translation>
    </message>
    <message>
        <source>{exchange} on the keyboard	next instrument</source>
        <translation>{exchange} auf der Tastatur	nächstes Instrument</translation>
    </message>
    <message>
        <source>Handle of the device	is that of its hand; the tip goes the other way</source>
        <translation>Griff des Geräts	ist der seiner Hand; die Spitze geht in die Gegenrichtung</translation>
    </message>
    <message>
        <source>Handle away from you, towards you	in, out</source>
        <translation>Griff von Ihnen weg, zu Ihnen hin	hinein, heraus</translation>
    </message>
    <message>
        <source>Turn the handle, or {turn}	turns the shaft</source>
        <translation>Griff drehen, oder {turn}	dreht den Schaft</translation>
    </message>
    <message>
        <source>Gripper; without one its first button	closes the jaws while held</source>
        <translation>Greifer; ohne ihn die erste Taste	schließt das Maul, solange gedrückt</translation>
    </message>
    <message>
        <source>First button; without a gripper the second	pedal of that hand (energy, suction)</source>
        <translation>Erste Taste; ohne Greifer die zweite	Pedal dieser Hand (Energie, Sauger)</translation>
    </message>
    <message>
        <source>Grip of the Inverse3	is the handle of its hand; the tip goes the other way</source>
        <translation>Griff des Inverse3	ist der Griff seiner Hand; die Spitze geht in die Gegenrichtung</translation>
    </message>
    <message>
        <source>Grip away from you, towards you	in, out</source>
        <translation>Griff von Ihnen weg, zu Ihnen hin	hinein, heraus</translation>
    </message>
    <message>
        <source>Turn the VerseGrip, or {turn}	turns the shaft</source>
        <translation>VerseGrip drehen, oder {turn}	dreht den Schaft</translation>
    </message>
    <message>
        <source>First button, or {each_jaws}	closes the jaws · the keys: they stay closed, or open again</source>
        <translation>Erste Taste, oder {each_jaws}	schließt das Maul · Tasten: es bleibt zu oder öffnet wieder</translation>
    </message>
    <message>
        <source>Second button, or {pedal}	pedal (energy, suction)</source>
        <translation>Zweite Taste, oder {pedal}	Pedal (Energie, Sauger)</translation>
    </message>
    <message>
        <source>Third button, or {exchange}	next instrument</source>
        <translation>Dritte Taste, oder {exchange}	nächstes Instrument</translation>
    </message>
    <message>
        <source>Tracked instrument	moves as you hold it; its handle is that of its hand</source>
        <translation>Getracktes Instrument	bewegt sich, wie Sie es halten; sein Griff ist der seiner Hand</translation>
    </message>
    <message>
        <source>Instrument away from you, towards you	in, out</source>
        <translation>Instrument von Ihnen weg, zu Ihnen hin	hinein, heraus</translation>
    </message>
    <message>
        <source>Turn the instrument	turns the shaft</source>
        <translation>Instrument drehen	dreht den Schaft</translation>
    </message>
    <message>
        <source>Its sensor, or {each_jaws}	closes the jaws · the keys: they stay closed, or open again</source>
        <translation>Sein Sensor, oder {each_jaws}	schließt das Maul · Tasten: es bleibt zu oder öffnet wieder</translation>
    </message>
    <message>
        <source>{pedal} on the keyboard	pedal (energy, suction)</source>
        <translation>{pedal} auf der Tastatur	Pedal (Energie, Sauger)</translation>
    </message>
    <message>
        <source>Tracked scope	scope: look · in, out</source>
        <translation>Getrackte Optik	Optik: sehen · hinein, heraus</translation>
    </message>
    <message>
        <source>Tracked scope	moves as you hold it; the lens goes the other way</source>
        <translation>Getrackte Optik	bewegt sich, wie Sie sie halten; die Linse geht in die Gegenrichtung</translation>
    </message>
    <message>
        <source>Scope away from you, towards you	in, out</source>
        <translation>Optik von Ihnen weg, zu Ihnen hin	hinein, heraus</translation>
    </message>
    <message>
        <source>Turn the scope	turns the light post: the direction in which the scope looks</source>
        <translation>Optik drehen	dreht den Lichtanschluss: die Blickrichtung der Optik</translation>
    </message>
    <message>
        <source>Cap to the side, up, down	moves the handle of its hand; the tip goes the other way</source>
        <translation>Kappe seitwärts, auf, ab	bewegt den Griff ihrer Hand; die Spitze geht in die Gegenrichtung</translation>
    </message>
    <message>
        <source>Cap away from you, towards you	in, out</source>
        <translation>Kappe von Ihnen weg, zu Ihnen hin	hinein, heraus</translation>
    </message>
    <message>
        <source>Turn the cap	turns the shaft</source>
        <translation>Kappe drehen	dreht den Schaft</translation>
    </message>
    <message>
        <source>First button	closes the jaws while held</source>
        <translation>Erste Taste	schließt das Maul, solange gedrückt</translation>
    </message>
    <message>
        <source>Cap of the SpaceMouse	scope: look · in, out</source>
        <translation>Kappe der SpaceMouse	Optik: sehen · hinein, heraus</translation>
    </message>
    <message>
        <source>Cap to the side, up, down	moves the handle of the scope; the lens goes the other way</source>
        <translation>Kappe seitwärts, auf, ab	bewegt den Griff der Optik; die Linse geht in die Gegenrichtung</translation>
    </message>
    <message>
        <source>Turn the cap	turns the light post: the direction in which the scope looks</source>
        <translation>Kappe drehen	dreht den Lichtanschluss: die Blickrichtung der Optik</translation>
    </message>
    <message>
        <source>Instrument of the trainer	moves as you hold it; the tip goes the other way</source>
        <translation>Instrument des Trainers	bewegt sich, wie Sie es halten; die Spitze geht in die Gegenrichtung</translation>
    </message>
    <message>
        <source>Push, pull the instrument	in, out</source>
        <translation>Instrument schieben, ziehen	hinein, heraus</translation>
    </message>
    <message>
        <source>Close its handle, or {each_jaws}	closes the jaws · the keys: they stay closed, or open again</source>
        <translation>Griff schließen, oder {each_jaws}	schließt das Maul · Tasten: es bleibt zu oder öffnet wieder</translation>
    </message>
    <message>
        <source>Pedal of the trainer, or {pedal}	pedal (energy, suction)</source>
        <translation>Pedal des Trainers, oder {pedal}	Pedal (Energie, Sauger)</translation>
    </message>
    <message>
        <source>Button of the trainer, or {exchange}	next instrument</source>
        <translation>Taste des Trainers, oder {exchange}	nächstes Instrument</translation>
    </message>
    <message>
        <source>Scope of the trainer	scope: look · in, out</source>
        <translation>Optik des Trainers	Optik: sehen · hinein, heraus</translation>
    </message>
    <message>
        <source>Scope of the trainer	moves as you hold it; the lens goes the other way</source>
        <translation>Optik des Trainers	bewegt sich, wie Sie sie halten; die Linse geht in die Gegenrichtung</translation>
    </message>
    <message>
        <source>Push, pull the scope	in, out</source>
        <translation>Optik schieben, ziehen	hinein, heraus</translation>
    </message>
    <message>
        <source>Mouse · wheel	the right hand · in and out</source>
        <translation>Maus · Rad	die rechte Hand · hinein und heraus</translation>
    </message>
    <message>
        <source>Mouse · wheel	the left hand · in and out</source>
        <translation>Maus · Rad	die linke Hand · hinein und heraus</translation>
    </message>
    <message>
        <source>{each_jaws}	jaws of the left, right hand stay closed, or open again</source>
        <translation>{each_jaws}	Maul der linken, rechten Hand bleibt zu oder öffnet wieder</translation>
    </message>
    <message>
        <source>{turn}	turns the shaft: left, right hand</source>
        <translation>{turn}	dreht den Schaft: linke, rechte Hand</translation>
    </message>
    <message>
        <source>{pedal} · {exchange}	pedal · next instrument, with every device</source>
        <translation>{pedal} · {exchange}	Pedal · nächstes Instrument, mit jedem Gerät</translation>
    </message>
    <message>
        <source>Turn the instrument, or {turn}	turns the shaft</source>
        <translation>Instrument drehen, oder {turn}	dreht den Schaft</translation>
    </message>
    <message>
        <source>Instrument on the joystick	moves as you hold it; the tip goes the other way</source>
        <translation>Instrument am Joystick	folgt Ihrer Hand; die Spitze bewegt sich in die Gegenrichtung</translation>
    </message>
    <message>
        <source>Script of the device</source>
        <translation>Skript des Geräts</translation>
    </message>
    <message>
        <source>Rear button of the stylus</source>
        <translation>Hintere Taste des Stifts</translation>
    </message>
    <message>
        <source>Second button; without a gripper the fourth</source>
        <translation>Zweite Taste; ohne Greifer die vierte</translation>
    </message>
    <message>
        <source>First button; without a gripper the second</source>
        <translation>Erste Taste; ohne Greifer die zweite</translation>
    </message>
    <message>
        <source>Second button</source>
        <translation>Zweite Taste</translation>
    </message>
    <message>
        <source>Clutch button of the instrument</source>
        <translation>Kupplungstaste des Instruments</translation>
    </message>
    <message>
        <source>Clutch button of the trainer</source>
        <translation>Kupplungstaste des Trainers</translation>
    </message>
    <message>
        <source>Clutch button of the joystick</source>
        <translation>Kupplungstaste des Joysticks</translation>
    </message>
    <message>
        <source>Button of the left device, or {pedal}	pedal (energy, suction)</source>
        <translation>Taste des linken Geräts oder {pedal}	Pedal (Energie, Sauger)</translation>
    </message>
    <message>
        <source>Button of the right device, or {pedal}	pedal (energy, suction)</source>
        <translation>Taste des rechten Geräts oder {pedal}	Pedal (Energie, Sauger)</translation>
    </message>
    <message>
        <source>Button of the scope’s device, or {pedal}	pedal (energy, suction)</source>
        <translation>Taste des Geräts der Optik oder {pedal}	Pedal (Energie, Sauger)</translation>
    </message>
    <message>
        <source>Clutch button of the device</source>
        <translation>Kupplungstaste des Geräts</translation>
    </message>
    <message>
        <source>clutch: while held, only the handle moves</source>
        <translation>Kupplung: solange gehalten, bewegt sich nur der Griff</translation>
    </message>
    <message>
        <source>{device}	its handle is that of its hand; the tip goes the other way</source>
        <translation>{device}	sein Griff ist der seiner Hand; die Spitze geht in die Gegenrichtung</translation>
    </message>
    <message>
        <source>Jaws of the handle, or {each_jaws}	closes the jaws · the keys: they stay closed, or open again</source>
        <translation>Maul am Griff, oder {each_jaws}	schließt das Maul · Tasten: es bleibt zu oder öffnet wieder</translation>
    </message>
    <message>
        <source>Pedal of the device, or {pedal}	pedal (energy, suction)</source>
        <translation>Pedal des Geräts, oder {pedal}	Pedal (Energie, Sauger)</translation>
    </message>
    <message>
        <source>{device}	scope: look · in, out</source>
        <translation>{device}	Optik: sehen · hinein, heraus</translation>
    </message>
    <message>
        <source>{device}	its handle is that of the scope; the lens goes the other way</source>
        <translation>{device}	sein Griff ist der der Optik; die Linse geht in die Gegenrichtung</translation>
    </message>
    <message>
        <source>Turn the handle	turns the light post: the direction in which the scope looks</source>
        <translation>Griff drehen	dreht den Lichtanschluss: die Blickrichtung der Optik</translation>
    </message>
</context>
<context>
    <name>fulcrum::tissues</name>
    <message>
        <source>Force across the tissue to break through</source>
        <translation>Kraft quer zum Gewebe bis zum Durchbruch</translation>
    </message>
    <message>
        <source>Force along the tissue to break through</source>
        <translation>Kraft längs des Gewebes bis zum Durchbruch</translation>
    </message>
    <message>
        <source>Force along the tissue to continue a cut</source>
        <translation>Kraft längs des Gewebes, um einen Schnitt fortzusetzen</translation>
    </message>
    <message>
        <source>Fraction of these forces with energy on</source>
        <translation>Anteil dieser Kräfte bei eingeschaltetem Strom</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::ActionsCard</name>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Void this attempt</source>
        <translation>Für ungültig erklären</translation>
    </message>
    <message>
        <source>Void it for good</source>
        <translation>Endgültig für ungültig erklären</translation>
    </message>
    <message>
        <source>Reassign …</source>
        <translation>Neu zuordnen …</translation>
    </message>
    <message>
        <source>Request a correction</source>
        <translation>Korrektur anfragen</translation>
    </message>
    <message>
        <source>Performed by</source>
        <translation>Durchgeführt von</translation>
    </message>
    <message>
        <source>Void and copy for this person</source>
        <translation>Ungültig; Kopie für diese Person</translation>
    </message>
    <message>
        <source>Voiding removes the attempt from progress, cohorts and benchmarks. It stays visible, struck through, with your reason. Reassigning voids it as well and stores a copy, with recording and score, for the person who performed it.</source>
        <translation>Ein für ungültig erklärter Versuch zählt nicht mehr für Fortschritt, Gruppen und Richtwerte. Er bleibt sichtbar, durchgestrichen, mit Ihrem Grund. Neu zuordnen erklärt ihn ebenfalls für ungültig und speichert eine Kopie, mit Aufzeichnung und Bewertung, für die Person, die ihn durchgeführt hat.</translation>
    </message>
    <message>
        <source>Wrong person, or a mistaken attempt? An educator can void or reassign it.</source>
        <translation>Falsche Person oder ein irrtümlicher Versuch? Ein Ausbilder kann ihn für ungültig erklären oder neu zuordnen.</translation>
    </message>
    <message>
        <source>Enter a reason.</source>
        <translation>Geben Sie einen Grund an.</translation>
    </message>
    <message>
        <source>The attempt is voided.</source>
        <translation>Der Versuch ist für ungültig erklärt.</translation>
    </message>
    <message>
        <source>Reassigned to %1; this record is voided.</source>
        <translation>Neu zugeordnet zu %1; dieser Eintrag ist für ungültig erklärt.</translation>
    </message>
    <message>
        <source>Say what is wrong with this attempt.</source>
        <translation>Schreiben Sie, was an diesem Versuch nicht stimmt.</translation>
    </message>
    <message>
        <source>Your educators will see the request.</source>
        <translation>Ihre Ausbilder sehen die Anfrage.</translation>
    </message>
    <message>
        <source>Reason (kept in the audit log)</source>
        <translation>Grund (steht im Protokoll)</translation>
    </message>
    <message>
        <source>What is wrong with this attempt</source>
        <translation>Was an diesem Versuch nicht stimmt</translation>
    </message>
    <message>
        <source>a reason for a correction</source>
        <translation>ein Grund für eine Korrektur</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::AttemptChart</name>
    <message>
        <source>attempt</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>No attempts yet</source>
        <translation>Noch keine Versuche</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Attempt</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Counts</source>
        <translation>Zählt</translation>
    </message>
    <message>
        <source>Fitted curve</source>
        <translation>Angepasste Kurve</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>Arrow keys choose an attempt, Enter opens it.</source>
        <translation>Pfeiltasten wählen einen Versuch, die Eingabetaste öffnet ihn.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::AttemptsPage</name>
    <message>
        <source>Attempts</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Cohort</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Started</source>
        <translation>Beginn</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Comments</source>
        <translation>Kommentare</translation>
    </message>
    <message>
        <source>My attempts</source>
        <translation>Meine Versuche</translation>
    </message>
    <message>
        <source>Recompute</source>
        <translation>Neu berechnen</translation>
    </message>
    <message>
        <source>Recomputed: %1. The result differs from the score in force in %2 of them.</source>
        <translation>Neu berechnet: %1. Bei %2 davon weicht das Ergebnis von der geltenden Bewertung ab.</translation>
    </message>
    <message>
        <source>Some could not be recomputed: %1</source>
        <translation>Einige konnten nicht neu berechnet werden: %1</translation>
    </message>
    <message>
        <source>Recomputing …</source>
        <translation>Neuberechnung läuft …</translation>
    </message>
    <message>
        <source>All cohorts</source>
        <translation>Alle Gruppen</translation>
    </message>
    <message>
        <source>Everyone</source>
        <translation>Alle Personen</translation>
    </message>
    <message>
        <source>All tasks</source>
        <translation>Alle Aufgaben</translation>
    </message>
    <message>
        <source>Requested corrections: %1</source>
        <translation>Angefragte Korrekturen: %1</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source> (%1 unread)</source>
        <translation> (%1 ungelesen)</translation>
    </message>
    <message>
        <source>Voided by %1: %2</source>
        <translation>Für ungültig erklärt von %1: %2</translation>
    </message>
    <message>
        <source>The recording was imported as an external attempt.</source>
        <translation>Die Aufzeichnung wurde als externer Versuch importiert.</translation>
    </message>
    <message>
        <source>Open attempt</source>
        <translation>Versuch öffnen</translation>
    </message>
    <message>
        <source>Import a recording …</source>
        <translation>Aufzeichnung importieren …</translation>
    </message>
    <message numerus="yes">
        <source>%n scores were computed with older metrics or limits. Recomputing adds a second score to each attempt; the score in force does not change.</source>
        <translation>
            <numerusform>%n Bewertung wurde mit älteren Kennzahlen oder Grenzwerten berechnet. Neu berechnen fügt dem Versuch eine zweite Bewertung hinzu; die geltende Bewertung ändert sich nicht.</numerusform>
            <numerusform>%n Bewertungen wurden mit älteren Kennzahlen oder Grenzwerten berechnet. Neu berechnen fügt jedem Versuch eine zweite Bewertung hinzu; die geltende Bewertung ändert sich nicht.</numerusform>
        </translation>
    </message>
    <message>
        <source>People with three or more interrupted attempts in a row: %1</source>
        <translation>Personen mit drei oder mehr unterbrochenen Versuchen in Folge: %1</translation>
    </message>
    <message>
        <source>newest 500 attempts</source>
        <translation>die neuesten 500 Versuche</translation>
    </message>
    <message numerus="yes">
        <source>%n attempts</source>
        <translation>
            <numerusform>%n Versuch</numerusform>
            <numerusform>%n Versuche</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 interrupted attempts, the last on %2. Recorded: %3</source>
        <translation>%1 unterbrochene Versuche, der letzte am %2. Aufgezeichnet: %3</translation>
    </message>
    <message numerus="yes">
        <source>and of %n more people</source>
        <translation>
            <numerusform>und von %n weiteren Person</numerusform>
            <numerusform>und von %n weiteren Personen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::AuditPage</name>
    <message>
        <source>Audit log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Vorgang</translation>
    </message>
    <message>
        <source>Concerning</source>
        <translation>Betrifft</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Details</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Period</source>
        <translation>Zeitraum</translation>
    </message>
    <message>
        <source>All time</source>
        <translation>Unbegrenzt</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>Heute</translation>
    </message>
    <message>
        <source>Last 7 days</source>
        <translation>Letzte 7 Tage</translation>
    </message>
    <message>
        <source>Last 30 days</source>
        <translation>Letzte 30 Tage</translation>
    </message>
    <message>
        <source>From … to …</source>
        <translation>Von … bis …</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Everyone</source>
        <translation>Alle Personen</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>Row %1, object %2, hash %3</source>
        <translation>Zeile %1, Objekt %2, Hash %3</translation>
    </message>
    <message>
        <source>Checking the audit log …</source>
        <translation>Protokoll wird geprüft …</translation>
    </message>
    <message>
        <source>✓ The audit log is intact: %1 rows.
Newest hash: %2</source>
        <translation>✓ Das Protokoll ist unversehrt: %1 Zeilen.
Neuester Hash: %2</translation>
    </message>
    <message>
        <source>✕ The audit log is damaged: %1 rows.
Newest hash: %2</source>
        <translation>✕ Das Protokoll ist beschädigt: %1 Zeilen.
Neuester Hash: %2</translation>
    </message>
    <message>
        <source>
and %1 more</source>
        <translation>
und %1 weitere</translation>
    </message>
    <message>
        <source>The audit log could not be read: %1</source>
        <translation>Das Protokoll konnte nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>Show older entries</source>
        <translation>Ältere Einträge zeigen</translation>
    </message>
    <message>
        <source>Comments and reasons about an attempt are not shown here; people who may open the attempt see them there. A person who can write to the store&apos;s file could rewrite the whole log: compare the newest hash above with the one printed in a report.</source>
        <translation>Kommentare und Begründungen zu einem Versuch stehen nicht hier; wer den Versuch öffnen darf, sieht sie dort. Eine Person, die in die Datei des Datenbestands schreiben kann, könnte das ganze Protokoll neu schreiben: Vergleichen Sie den neuesten Hash oben mit dem in einem Bericht.</translation>
    </message>
    <message numerus="yes">
        <source>%n entries shown</source>
        <translation>
            <numerusform>%n Eintrag gezeigt</numerusform>
            <numerusform>%n Einträge gezeigt</numerusform>
        </translation>
    </message>
    <message>
        <source>Station</source>
        <translation>Arbeitsplatz</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::BenchmarkPage</name>
    <message>
        <source>Build limits</source>
        <translation>Grenzwerte bilden</translation>
    </message>
    <message>
        <source>A benchmark set is made from the assessed attempts of at least %1 experts who performed the task %2 times or more. The first %3 attempts of each person are familiarisation and do not count. Nothing changes until you put the set in force.</source>
        <translation>Ein Satz von Grenzwerten entsteht aus den bewerteten Versuchen von mindestens %1 Experten, die die Aufgabe %2-mal oder öfter durchgeführt haben. Die ersten %3 Versuche jeder Person dienen der Eingewöhnung und zählen nicht. Es ändert sich nichts, bis Sie den Satz in Kraft setzen.</translation>
    </message>
    <message>
        <source>What the limits are for</source>
        <translation>Wofür die Grenzwerte gelten</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Variant</source>
        <translation>Variante</translation>
    </message>
    <message>
        <source>Class of devices</source>
        <translation>Geräteklasse</translation>
    </message>
    <message>
        <source>Fidelity</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>Experts</source>
        <translation>Experten</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Counted</source>
        <translation>Gezählt</translation>
    </message>
    <message>
        <source>People with attempts at this task</source>
        <translation>Personen mit Versuchen an dieser Aufgabe</translation>
    </message>
    <message>
        <source>Build the set</source>
        <translation>Satz bilden</translation>
    </message>
    <message>
        <source>The set</source>
        <translation>Der Satz</translation>
    </message>
    <message>
        <source>Who would pass with each set</source>
        <translation>Wer mit welchem Satz bestehen würde</translation>
    </message>
    <message>
        <source>Why this set is made (in the audit log and in the set)</source>
        <translation>Warum dieser Satz entsteht (steht im Prüfprotokoll und im Satz)</translation>
    </message>
    <message>
        <source>Put in force</source>
        <translation>In Kraft setzen</translation>
    </message>
    <message>
        <source>File for another station, or for the administrator</source>
        <translation>Datei für eine andere Station oder für den Administrator</translation>
    </message>
    <message>
        <source>Save to a file</source>
        <translation>In eine Datei speichern</translation>
    </message>
    <message>
        <source>Reading the attempts …</source>
        <translation>Die Versuche werden gelesen …</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Nobody has an assessed and completed attempt of this kind here.</source>
        <translation>Niemand hat hier einen bewerteten und beendeten Versuch dieser Art.</translation>
    </message>
    <message>
        <source>Chosen: %1, of them with at least %2 counted attempts: %3. At least %4 are needed.</source>
        <translation>Gewählt: %1, davon mit mindestens %2 gezählten Versuchen: %3. Mindestens %4 sind nötig.</translation>
    </message>
    <message>
        <source>Building the set …</source>
        <translation>Der Satz wird gebildet …</translation>
    </message>
    <message>
        <source>✓ Usable. With k = %1, %2 % of the experts&apos; own attempts pass, each held against a set made without its expert.</source>
        <translation>✓ Verwendbar. Mit k = %1 bestehen %2 % der eigenen Versuche der Experten, jeder an einem Satz gemessen, der ohne seinen Experten entstand.</translation>
    </message>
    <message>
        <source>✕ Refused: %1.</source>
        <translation>✕ Abgelehnt: %1.</translation>
    </message>
    <message>
        <source>No attempt stored here counts under these limits yet.</source>
        <translation>Noch zählt kein hier gespeicherter Versuch unter diesen Grenzwerten.</translation>
    </message>
    <message>
        <source>Each dot is an attempt that counts; a line with a letter is the limit of a set.</source>
        <translation>Jeder Punkt ist ein Versuch, der zählt; eine Linie mit Buchstabe ist der Grenzwert eines Satzes.</translation>
    </message>
    <message>
        <source>the new set (%1)</source>
        <translation>der neue Satz (%1)</translation>
    </message>
    <message>
        <source>in force (%1)</source>
        <translation>geltend (%1)</translation>
    </message>
    <message>
        <source>%1: %2 is left out, whose mean is more than 1.96 standard deviations from that of the experts.</source>
        <translation>%1: %2 bleibt außer Betracht; der Mittelwert liegt mehr als 1,96 Standardabweichungen von dem der Experten entfernt.</translation>
    </message>
    <message>
        <source>%1: the limit is the worst value of the experts, %2.</source>
        <translation>%1: Der Grenzwert ist der schlechteste Wert der Experten, %2.</translation>
    </message>
    <message>
        <source>%1: failed by %2 of the experts&apos; own attempts.</source>
        <translation>%1: von %2 der eigenen Versuche der Experten nicht erfüllt.</translation>
    </message>
    <message>
        <source>Provisional: these attempts are simulated. Nobody becomes proficient by a pass with this set, and it takes over no limits of the task.</source>
        <translation>Vorläufig: Diese Versuche sind simuliert. Mit diesem Satz wird „sicher beherrscht“ nie festgestellt, und er übernimmt keine Grenzwerte der Aufgabe.</translation>
    </message>
    <message>
        <source>Provisional limits of the task that the set takes over as limits of your site when you put it in force: %1. The experts&apos; own attempts above were judged by them too.</source>
        <translation>Vorläufige Grenzwerte der Aufgabe, die der Satz als Grenzwerte Ihres Standorts übernimmt, wenn Sie ihn in Kraft setzen: %1. Auch die eigenen Versuche der Experten oben wurden daran gemessen.</translation>
    </message>
    <message>
        <source>Version %1 of %2 is in force. Attempts that have begun keep their limits.</source>
        <translation>Version %1 von %2 gilt. Begonnene Versuche behalten ihre Grenzwerte.</translation>
    </message>
    <message>
        <source>Wrote %1. Attempts are held against it once it is among the program&apos;s benchmark sets and accepted.</source>
        <translation>%1 geschrieben. Versuche werden daran gemessen, sobald der Satz bei den Grenzwerten des Programms liegt und angenommen ist.</translation>
    </message>
    <message>
        <source>The attempts were not read. Choose the task again to read them.</source>
        <translation>Die Versuche wurden nicht gelesen. Wählen Sie die Aufgabe noch einmal, um sie zu lesen.</translation>
    </message>
    <message>
        <source>a set of limits that is being built (%1)</source>
        <translation>ein Satz von Grenzwerten, der gebildet wird (%1)</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::BriefingPage</name>
    <message>
        <source>With %1 your curriculum (%2) does not count this task, but with: %3. Because you may build limits, the attempt can be assessed: for a benchmark set, not for your standing.</source>
        <translation>Mit %1 zählt Ihr Curriculum (%2) diese Aufgabe nicht, wohl aber mit: %3. Weil Sie Grenzwerte bilden dürfen, kann der Versuch bewertet werden: für einen Richtwertsatz, nicht für Ihren Stand.</translation>
    </message>
    <message>
        <source>You follow the curriculum %1, which is not at this station. Until it is, you can only practise this task.</source>
        <translation>Sie folgen dem Curriculum %1, das an dieser Station fehlt. Bis es da ist, können Sie diese Aufgabe nur üben.</translation>
    </message>
    <message>
        <source>One mouse for each hand: practice only. No limits exist for two mice; your score is compared with those of mouse and keyboard, where the task has them. F1 shows what the buttons do.</source>
        <translation>Je eine Maus für jede Hand: nur Übung. Für zwei Mäuse gibt es keine Grenzwerte; Ihre Bewertung wird mit denen für Maus und Tastatur verglichen, soweit die Aufgabe welche hat. F1 zeigt, was die Tasten tun.</translation>
    </message>
    <message>
        <source>A script moves the hands (%1): practice only. What it does not have is moved with mouse and keyboard; F1 shows the keys.</source>
        <translation>Ein Skript bewegt die Hände (%1): nur Übung. Was es nicht hat, bewegen Sie mit Maus und Tastatur; F1 zeigt die Tasten.</translation>
    </message>
    <message>
        <source>You work with: %1. What it does not have is moved with mouse and keyboard; F1 shows the keys.</source>
        <translation>Sie arbeiten mit: %1. Was es nicht hat, bewegen Sie mit Maus und Tastatur; F1 zeigt die Tasten.</translation>
    </message>
    <message>
        <source>With %1 this task is practice only; it is assessed with: %2.</source>
        <translation>Mit %1 ist diese Aufgabe nur Übung; bewertet wird sie mit: %2.</translation>
    </message>
    <message>
        <source>← Home</source>
        <translation>← Startseite</translation>
    </message>
    <message>
        <source>Does it count?</source>
        <translation>Zählt es?</translation>
    </message>
    <message>
        <source>Assessed: it counts from the first movement, even if you abandon it.</source>
        <translation>Bewertet: zählt ab der ersten Bewegung, auch wenn Sie abbrechen.</translation>
    </message>
    <message>
        <source>Practice: it is scored and kept, but does not count.</source>
        <translation>Übung: wird ausgewertet und gespeichert, zählt aber nicht.</translation>
    </message>
    <message>
        <source>Watch an expert do it</source>
        <translation>Einem Experten zusehen</translation>
    </message>
    <message>
        <source>My attempts and learning curve</source>
        <translation>Meine Versuche und Lernkurve</translation>
    </message>
    <message>
        <source>Variant</source>
        <translation>Variante</translation>
    </message>
    <message>
        <source>%1 (not practised yet)</source>
        <translation>%1 (noch nicht geübt)</translation>
    </message>
    <message>
        <source>%1 (attempts: %2)</source>
        <translation>%1 (Versuche: %2)</translation>
    </message>
    <message>
        <source>The variant practised least comes next unless you choose one.</source>
        <translation>Die am wenigsten geübte Variante kommt als Nächstes, wenn Sie keine wählen.</translation>
    </message>
    <message>
        <source>Chosen because you have practised it least.</source>
        <translation>Gewählt, weil Sie sie am wenigsten geübt haben.</translation>
    </message>
    <message>
        <source>Begin at</source>
        <translation>Beginn</translation>
    </message>
    <message>
        <source>Begin practice at</source>
        <translation>Beginn der Übung</translation>
    </message>
    <message>
        <source>From a later goal on, a simulated expert does what comes before. Such a practice run is never scored.</source>
        <translation>Ab einem späteren Schritt übernimmt ein simulierter Experte, was davor kommt. Eine solche Übung wird nie ausgewertet.</translation>
    </message>
    <message>
        <source>the beginning</source>
        <translation>am Anfang</translation>
    </message>
    <message>
        <source>%1 (sha256 %2)</source>
        <translation>%1 (sha256 %2)</translation>
    </message>
    <message>
        <source>Here this task is practice only: it uses files that are neither part of this program nor accepted by the programme: %1. An educator can accept them.</source>
        <translation>Hier ist diese Aufgabe nur Übung: Sie verwendet Dateien, die weder zu dieser Software gehören noch vom Programm anerkannt sind: %1. Ein Ausbilder kann sie anerkennen.</translation>
    </message>
    <message>
        <source>Start as %1</source>
        <translation>Als %1 starten</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Was zu tun ist</translation>
    </message>
    <message>
        <source>You hold the scope with mouse and keyboard. F1 shows the keys.</source>
        <translation>Sie führen die Optik mit Maus und Tastatur. F1 zeigt die Tasten.</translation>
    </message>
    <message>
        <source>You work with mouse and keyboard: force is shown as bars, not felt. F1 shows the keys.</source>
        <translation>Sie arbeiten mit Maus und Tastatur: Die Kraft wird als Balken gezeigt und ist nicht zu spüren. F1 zeigt die Tasten.</translation>
    </message>
    <message>
        <source>The demonstration accepts practice attempts only.</source>
        <translation>In der Vorführung sind nur Übungen möglich.</translation>
    </message>
    <message>
        <source>%1 differs by %2 %</source>
        <translation>%1 weicht um %2 % ab</translation>
    </message>
    <message>
        <source>%1 of %2 verdicts differ</source>
        <translation>abweichende Urteile: %1 von %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>the same score</source>
        <translation>dieselbe Bewertung</translation>
    </message>
    <message>
        <source>Gates based on the experts&apos; range are not scored: %1.</source>
        <translation>Kriterien, die auf dem Bereich der Experten beruhen, werden nicht ausgewertet: %1.</translation>
    </message>
    <message>
        <source>A simulated expert performs the task. Nothing is stored. Press Esc to stop.</source>
        <translation>Ein simulierter Experte führt die Aufgabe durch. Es wird nichts gespeichert. Drücken Sie Esc, um zu beenden.</translation>
    </message>
    <message>
        <source>Show an expert&apos;s instruments</source>
        <translation>Instrumente eines Experten zeigen</translation>
    </message>
    <message>
        <source>Translucent instruments show an expert&apos;s next movement and wait for you. The scene is the one in which the expert was simulated.</source>
        <translation>Durchscheinende Instrumente zeigen die nächste Bewegung eines Experten und warten auf Sie. Die Szene ist die, in der der Experte simuliert wurde.</translation>
    </message>
    <message>
        <source>This task is not part of your curriculum (%1): assessed attempts are scored, but lead to no proficiency.</source>
        <translation>Diese Aufgabe gehört nicht zu Ihrem Curriculum (%1): bewertete Versuche erhalten Punkte, führen aber nicht zu sicherem Beherrschen.</translation>
    </message>
    <message>
        <source>With %1 this task is practice only: your curriculum (%2) counts it with: %3.</source>
        <translation>Mit %1 ist diese Aufgabe nur Übung: Ihr Curriculum (%2) zählt sie mit: %3.</translation>
    </message>
    <message>
        <source>This task is %1. Until then, you can only practise it.</source>
        <translation>Diese Aufgabe ist %1. Bis dahin können Sie sie nur üben.</translation>
    </message>
    <message>
        <source>Time limit %1 · Outcome: %2</source>
        <translation>Zeitlimit %1 · Ergebnis: %2</translation>
    </message>
    <message>
        <source>The effect of the simulation&apos;s level of detail on the score has not been measured for this task.</source>
        <translation>Die Wirkung der Genauigkeit der Simulation auf die Bewertung ist für diese Aufgabe nicht gemessen.</translation>
    </message>
    <message>
        <source>Effect of the simulation&apos;s level of detail on the score, compared with the level &quot;%1&quot;: %2.</source>
        <translation>Wirkung der Genauigkeit der Simulation auf die Bewertung, verglichen mit der Stufe „%1“: %2.</translation>
    </message>
    <message>
        <source>Measured with an earlier version of the simulation, the metrics or the limits.</source>
        <translation>Gemessen mit einer früheren Version der Simulation, der Kennzahlen oder der Grenzwerte.</translation>
    </message>
    <message>
        <source>This site uses its own tissue values (version %1); its cutting parameters differ from those of the scene.</source>
        <translation>Dieser Standort benutzt eigene Gewebewerte (Version %1); seine Schnittparameter weichen von denen der Szene ab.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::CalibrationBox</name>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Hand whose instrument is calibrated</source>
        <translation>Hand, deren Instrument kalibriert wird</translation>
    </message>
    <message>
        <source>Right hand</source>
        <translation>Rechte Hand</translation>
    </message>
    <message>
        <source>Left hand</source>
        <translation>Linke Hand</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Leave this out</source>
        <translation>Weglassen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Not calibrated with this program yet.</source>
        <translation>Noch nicht mit diesem Programm kalibriert.</translation>
    </message>
    <message>
        <source>Calibrated last: %1.</source>
        <translation>Zuletzt kalibriert: %1.</translation>
    </message>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>Schritt %1 von %2: %3</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::CertificateCard</name>
    <message>
        <source>No certificate: the curriculum %1, which is followed, is not at this station.</source>
        <translation>Kein Zertifikat: Das Curriculum %1, dem gefolgt wird, fehlt an dieser Station.</translation>
    </message>
    <message>
        <source>Stage %1, %2, completed on %3. Check code %4.</source>
        <translation>Stufe %1, %2, abgeschlossen am %3. Prüfcode %4.</translation>
    </message>
    <message>
        <source>Save the certificate (PDF)</source>
        <translation>Zertifikat speichern (PDF)</translation>
    </message>
    <message>
        <source>Certificate %1 %2</source>
        <translation>Zertifikat %1 %2</translation>
    </message>
    <message>
        <source>The stage is no longer completed.</source>
        <translation>Die Stufe ist nicht mehr abgeschlossen.</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>Stage %1, %2, completed on %3 under %4, before the move to %5. Check code %6.</source>
        <translation>Stufe %1, %2, abgeschlossen am %3 unter %4, vor der Umstellung auf %5. Prüfcode %6.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::ChartFrame</name>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>%1: show the values as a table</source>
        <translation>%1: Werte als Tabelle zeigen</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Bild kopieren</translation>
    </message>
    <message>
        <source>%1: copy as a picture</source>
        <translation>%1: als Bild kopieren</translation>
    </message>
    <message>
        <source>Copy data</source>
        <translation>Daten kopieren</translation>
    </message>
    <message>
        <source>%1: copy the values, to be pasted into a spreadsheet</source>
        <translation>%1: Werte kopieren, zum Einfügen in eine Tabellenkalkulation</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>Diagramm</translation>
    </message>
    <message>
        <source>%1: show the chart</source>
        <translation>%1: Diagramm zeigen</translation>
    </message>
    <message>
        <source>The picture was copied.</source>
        <translation>Das Bild wurde kopiert.</translation>
    </message>
    <message numerus="yes">
        <source>%n rows were copied.</source>
        <translation>
            <numerusform>%n Zeile wurde kopiert.</numerusform>
            <numerusform>%n Zeilen wurden kopiert.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::CohortGrid</name>
    <message>
        <source>%1, %2: %3. The curriculum %4 is not at this station.</source>
        <translation>%1, %2: %3. Das Curriculum %4 fehlt an dieser Station.</translation>
    </message>
    <message>
        <source>%1, %2: %3.</source>
        <translation>%1, %2: %3.</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>nicht bestanden</translation>
    </message>
    <message>
        <source> Latest attempts with %1: %2.</source>
        <translation> Letzte Versuche mit %1: %2.</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nie</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>Latest practice</source>
        <translation>Zuletzt geübt</translation>
    </message>
    <message>
        <source>What the signs mean</source>
        <translation>Bedeutung der Zeichen</translation>
    </message>
    <message>
        <source>Find a person</source>
        <translation>Person suchen</translation>
    </message>
    <message>
        <source>Standing</source>
        <translation>Stand</translation>
    </message>
    <message>
        <source>Any standing</source>
        <translation>Jeder Stand</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Reihenfolge</translation>
    </message>
    <message>
        <source>By name</source>
        <translation>Nach Name</translation>
    </message>
    <message>
        <source>Fewest tasks done first</source>
        <translation>Am wenigsten erledigt zuerst</translation>
    </message>
    <message>
        <source>Longest without practice first</source>
        <translation>Am längsten ohne Übung zuerst</translation>
    </message>
    <message>
        <source>People by tasks</source>
        <translation>Personen nach Aufgaben</translation>
    </message>
    <message>
        <source>Bars: the latest attempts, as high as their points. Filled: passed. Outline: failed. Dotted line: %1 points, the pass mark.</source>
        <translation>Balken: die letzten Versuche, so hoch wie ihre Punkte. Gefüllt: bestanden. Umriss: nicht bestanden. Gepunktete Linie: %1 Punkte, die Bestehensgrenze.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::CohortPage</name>
    <message>
        <source>?: the standing is not known here.</source>
        <translation>?: Der Stand ist hier nicht bekannt.</translation>
    </message>
    <message>
        <source>Reading the cohort …</source>
        <translation>Die Gruppe wird gelesen …</translation>
    </message>
    <message>
        <source>✓ passed (provisional)</source>
        <translation>✓ bestanden (vorläufig)</translation>
    </message>
    <message>
        <source>✓ passed</source>
        <translation>✓ bestanden</translation>
    </message>
    <message>
        <source>attempted</source>
        <translation>begonnen</translation>
    </message>
    <message>
        <source>not attempted</source>
        <translation>nicht begonnen</translation>
    </message>
    <message>
        <source>%1 · attempts %2</source>
        <translation>%1 · Versuche %2</translation>
    </message>
    <message>
        <source> · best %1</source>
        <translation> · Bestwert %1</translation>
    </message>
    <message>
        <source>Cohort</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Views of the cohort</source>
        <translation>Ansichten der Gruppe</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Aufgaben</translation>
    </message>
    <message>
        <source>Days of practice</source>
        <translation>Übungstage</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>Needs attention</source>
        <translation>Handlungsbedarf</translation>
    </message>
    <message>
        <source>There is no cohort yet. A director creates cohorts on the page &quot;Assign cohorts&quot;.</source>
        <translation>Es gibt noch keine Gruppe. Die Programmleitung legt Gruppen auf der Seite „Gruppen zuteilen“ an.</translation>
    </message>
    <message>
        <source> · deactivated: %1</source>
        <translation> · deaktiviert: %1</translation>
    </message>
    <message>
        <source> · synthetic left out: %1</source>
        <translation> · synthetische ausgelassen: %1</translation>
    </message>
    <message>
        <source>Needs attention (%1)</source>
        <translation>Handlungsbedarf (%1)</translation>
    </message>
    <message>
        <source>✓ passed, (✓) passed with provisional limits, ○ attempted, – not attempted. Then the best points and the number of attempts that count, with the type of device used last of those that have any; +1: with one type of device more. *: proficient by decision of an educator. The tool tip shows all, also where the arrow keys lead.</source>
        <translation>✓ bestanden, (✓) mit vorläufigen Grenzwerten bestanden, ○ versucht, – nicht versucht. Danach die besten Punkte und die Anzahl der Versuche, die zählen, mit der zuletzt benutzten Art von Gerät, für die es solche gibt; +1: eine weitere Art von Gerät. *: sicher beherrscht durch Entscheidung eines Ausbilders. Der Tooltip zeigt alle, auch dort, wohin die Pfeiltasten führen.</translation>
    </message>
    <message>
        <source>Show versions of limits and metrics</source>
        <translation>Versionen der Grenzwerte und Kennzahlen zeigen</translation>
    </message>
    <message>
        <source>Hide versions of limits and metrics</source>
        <translation>Versionen der Grenzwerte und Kennzahlen verbergen</translation>
    </message>
    <message numerus="yes">
        <source>%n people</source>
        <translation>
            <numerusform>%n Person</numerusform>
            <numerusform>%n Personen</numerusform>
        </translation>
    </message>
    <message>
        <source> · Only attempts that count. Types of device are not combined.</source>
        <translation> · Nur Versuche, die zählen. Arten von Geräten werden nicht zusammengefasst.</translation>
    </message>
    <message>
        <source>Benchmark sets: %1
Metrics: %2</source>
        <translation>Sätze von Grenzwerten: %1
Kennzahlen: %2</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::CohortsPage</name>
    <message>
        <source>Assign cohorts</source>
        <translation>Gruppen zuteilen</translation>
    </message>
    <message>
        <source>Add cohort</source>
        <translation>Gruppe anlegen</translation>
    </message>
    <message>
        <source>Cohorts</source>
        <translation>Gruppen</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Trainees</source>
        <translation>Lernende</translation>
    </message>
    <message>
        <source>Educators</source>
        <translation>Ausbilder</translation>
    </message>
    <message>
        <source>Saved.</source>
        <translation>Gespeichert.</translation>
    </message>
    <message>
        <source>Name of the new cohort</source>
        <translation>Name der neuen Gruppe</translation>
    </message>
    <message>
        <source>Save cohort</source>
        <translation>Gruppe speichern</translation>
    </message>
    <message>
        <source>a cohort that is not added yet</source>
        <translation>eine Gruppe, die noch nicht angelegt ist</translation>
    </message>
    <message>
        <source>changes to a cohort</source>
        <translation>Änderungen an einer Gruppe</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::CommentsCard</name>
    <message>
        <source>Comments</source>
        <translation>Kommentare</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Kommentar</translation>
    </message>
    <message>
        <source>What happens here, and one thing to try</source>
        <translation>Was hier geschieht, und ein Vorschlag zum Ausprobieren</translation>
    </message>
    <message>
        <source>Keep as draft</source>
        <translation>Entwurf speichern</translation>
    </message>
    <message>
        <source>Comment at %1</source>
        <translation>Kommentar bei %1</translation>
    </message>
    <message>
        <source>Comments (%1)</source>
        <translation>Kommentare (%1)</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source> · draft, visible only to you</source>
        <translation> · Entwurf, nur für Sie sichtbar</translation>
    </message>
    <message>
        <source> · new</source>
        <translation> · neu</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>Senden</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>No comments yet.</source>
        <translation>Noch keine Kommentare.</translation>
    </message>
    <message>
        <source>Your comment was kept as a draft of %1.</source>
        <translation>Ihr Kommentar wurde als Entwurf bei %1 aufbewahrt.</translation>
    </message>
    <message>
        <source> · reason for an error, not given yet, visible only to you</source>
        <translation> · Begründung zu einem Fehler, noch nicht abgegeben, nur für Sie sichtbar</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::ComparePage</name>
    <message>
        <source>No picture: %1</source>
        <translation>Kein Bild: %1</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Reading the other attempt …</source>
        <translation>Der andere Versuch wird gelesen …</translation>
    </message>
    <message>
        <source>An expert performs the task …</source>
        <translation>Ein Experte führt die Aufgabe aus …</translation>
    </message>
    <message>
        <source>Reading the attempts of the cohort …</source>
        <translation>Die Versuche der Kohorte werden gelesen …</translation>
    </message>
    <message>
        <source>Expert of the benchmark (simulated)</source>
        <translation>Experte des Benchmarks (simuliert)</translation>
    </message>
    <message>
        <source>duration %1</source>
        <translation>Dauer %1</translation>
    </message>
    <message>
        <source>← Back to the attempt</source>
        <translation>← Zurück zum Versuch</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>Vergleichen mit</translation>
    </message>
    <message>
        <source>Moment of both attempts</source>
        <translation>Zeitpunkt beider Versuche</translation>
    </message>
    <message>
        <source>◀ Step</source>
        <translation>◀ Schritt</translation>
    </message>
    <message>
        <source>Step ▶</source>
        <translation>Schritt ▶</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>What is drawn</source>
        <translation>Was gezeichnet wird</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>left hand</source>
        <translation>linke Hand</translation>
    </message>
    <message>
        <source>right hand</source>
        <translation>rechte Hand</translation>
    </message>
    <message>
        <source>Force and speed</source>
        <translation>Kraft und Geschwindigkeit</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Kennzahlen</translation>
    </message>
    <message>
        <source>Stopped. Choose again what to compare with.</source>
        <translation>Abgebrochen. Wählen Sie erneut, womit verglichen wird.</translation>
    </message>
    <message>
        <source>Compare: %1</source>
        <translation>Vergleich: %1</translation>
    </message>
    <message>
        <source>Reading the attempt …</source>
        <translation>Der Versuch wird gelesen …</translation>
    </message>
    <message>
        <source>This attempt: %1</source>
        <translation>Dieser Versuch: %1</translation>
    </message>
    <message>
        <source>There is nothing to compare this attempt with.</source>
        <translation>Es gibt nichts, womit dieser Versuch verglichen werden kann.</translation>
    </message>
    <message>
        <source>Force of the left hand (N)</source>
        <translation>Kraft der linken Hand (N)</translation>
    </message>
    <message>
        <source>Speed of the left hand (mm/s)</source>
        <translation>Geschwindigkeit der linken Hand (mm/s)</translation>
    </message>
    <message>
        <source>Force of the right hand (N)</source>
        <translation>Kraft der rechten Hand (N)</translation>
    </message>
    <message>
        <source>Speed of the right hand (mm/s)</source>
        <translation>Geschwindigkeit der rechten Hand (mm/s)</translation>
    </message>
    <message>
        <source>left (N)</source>
        <translation>links (N)</translation>
    </message>
    <message>
        <source>left (mm/s)</source>
        <translation>links (mm/s)</translation>
    </message>
    <message>
        <source>right (N)</source>
        <translation>rechts (N)</translation>
    </message>
    <message>
        <source>right (mm/s)</source>
        <translation>rechts (mm/s)</translation>
    </message>
    <message>
        <source>cohort</source>
        <translation>Kohorte</translation>
    </message>
    <message>
        <source>this attempt</source>
        <translation>dieser Versuch</translation>
    </message>
    <message>
        <source>; metrics of this attempt alone</source>
        <translation>; nur Kennzahlen dieses Versuchs</translation>
    </message>
    <message>
        <source>Hold Shift and drag to choose a part.</source>
        <translation>Mit gedrückter Umschalttaste ziehen, um einen Abschnitt zu wählen.</translation>
    </message>
    <message>
        <source>Other attempt: %1</source>
        <translation>Anderer Versuch: %1</translation>
    </message>
    <message>
        <source>other attempt</source>
        <translation>anderer Versuch</translation>
    </message>
    <message>
        <source>; other attempt %1 to %2</source>
        <translation>; anderer Versuch %1 bis %2</translation>
    </message>
    <message>
        <source>; other attempt %1 / %2</source>
        <translation>; anderer Versuch %1 / %2</translation>
    </message>
    <message>
        <source>; no metrics of a part, because this program does not have the task</source>
        <translation>; keine Kennzahlen eines Teils, weil dieses Programm die Aufgabe nicht hat</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::ComparisonTable</name>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>✓ better</source>
        <translation>✓ besser</translation>
    </message>
    <message>
        <source>✕ worse</source>
        <translation>✕ schlechter</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Kennzahl</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Hand</translation>
    </message>
    <message>
        <source>This attempt</source>
        <translation>Dieser Versuch</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Unterschied</translation>
    </message>
    <message>
        <source>This attempt is</source>
        <translation>Dieser Versuch ist</translation>
    </message>
    <message>
        <source>Differences of the metrics</source>
        <translation>Unterschiede der Kennzahlen</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1 (%2 bis %3)</translation>
    </message>
    <message>
        <source>in the middle half</source>
        <translation>in der mittleren Hälfte</translation>
    </message>
    <message>
        <source>Cohort: median (middle half)</source>
        <translation>Kohorte: Median (mittlere Hälfte)</translation>
    </message>
    <message>
        <source>Other attempt</source>
        <translation>Anderer Versuch</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Abschnitt</translation>
    </message>
    <message>
        <source>Whole attempt</source>
        <translation>Ganzer Versuch</translation>
    </message>
    <message>
        <source>Metrics of the part</source>
        <translation>Kennzahlen des Abschnitts</translation>
    </message>
    <message>
        <source>measured by another version of the metric</source>
        <translation>nach einer anderen Version der Kennzahl gemessen</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::ComparisonTexts</name>
    <message>
        <source>An expert of the benchmark (simulated)</source>
        <translation>Ein Experte des Benchmarks (simuliert)</translation>
    </message>
    <message>
        <source>Cohort %1 as a band</source>
        <translation>Kohorte %1 als Band</translation>
    </message>
    <message>
        <source>Nothing was recorded.</source>
        <translation>Nichts wurde aufgezeichnet.</translation>
    </message>
    <message>
        <source>Different versions of the task: %1 and %2.</source>
        <translation>Verschiedene Versionen der Aufgabe: %1 und %2.</translation>
    </message>
    <message>
        <source>This attempt: %1</source>
        <translation>Dieser Versuch: %1</translation>
    </message>
    <message numerus="yes">
        <source>Aligned by the %n steps that were completed in both.</source>
        <translation>
            <numerusform>Ausgerichtet an %n Schritt, der in beiden abgeschlossen wurde.</numerusform>
            <numerusform>Ausgerichtet an den %n Schritten, die in beiden abgeschlossen wurden.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %n other people have completed this task with this variant and class of device. A band needs at least 5.</source>
        <translation>
            <numerusform>%1: %n andere Person hat diese Aufgabe mit dieser Variante und Geräteklasse abgeschlossen. Ein Band braucht mindestens 5.</numerusform>
            <numerusform>%1: %n andere Personen haben diese Aufgabe mit dieser Variante und Geräteklasse abgeschlossen. Ein Band braucht mindestens 5.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: the latest counting attempt of %n other people. Line: median; band: the middle half.</source>
        <translation>
            <numerusform>%1: der letzte zählende Versuch von %n anderen Person. Linie: Median; Band: die mittlere Hälfte.</numerusform>
            <numerusform>%1: der letzte zählende Versuch von %n anderen Personen. Linie: Median; Band: die mittlere Hälfte.</numerusform>
        </translation>
    </message>
    <message>
        <source>Best attempt: %1</source>
        <translation>Bester Versuch: %1</translation>
    </message>
    <message>
        <source>Latest attempt: %1</source>
        <translation>Letzter Versuch: %1</translation>
    </message>
    <message>
        <source>Different variants: %1 and %2. The scenes differ; the attempts are aligned by steps.</source>
        <translation>Verschiedene Varianten: %1 und %2. Die Szenen sind verschieden; die Versuche sind nach Schritten ausgerichtet.</translation>
    </message>
    <message>
        <source>Different devices: %1 and %2. Their values cannot be compared directly.</source>
        <translation>Verschiedene Geräte: %1 und %2. Ihre Werte sind nicht direkt vergleichbar.</translation>
    </message>
    <message>
        <source>Other attempt: %1</source>
        <translation>Anderer Versuch: %1</translation>
    </message>
    <message>
        <source>No step was completed in both attempts, so they are aligned at the beginning of step %1.</source>
        <translation>Kein Schritt wurde in beiden Versuchen abgeschlossen; darum sind sie am Beginn von Schritt %1 ausgerichtet.</translation>
    </message>
    <message>
        <source>No step was completed in both attempts, so they are aligned at the first movement.</source>
        <translation>Kein Schritt wurde in beiden Versuchen abgeschlossen; darum sind sie an der ersten Bewegung ausgerichtet.</translation>
    </message>
    <message numerus="yes">
        <source>The recording of %n of them was not kept here: only their metrics are compared.</source>
        <translation>
            <numerusform>Von %n Person wurde die Aufzeichnung hier nicht behalten: Nur ihre Kennzahlen werden verglichen.</numerusform>
            <numerusform>Von %n Personen wurde die Aufzeichnung hier nicht behalten: Nur ihre Kennzahlen werden verglichen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Values that another version of the metric measured are left out: %1.</source>
        <translation>Werte, die nach einer anderen Version der Kennzahl gemessen sind, sind weggelassen: %1.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::Context</name>
    <message>
        <source>External: %1</source>
        <translation>Extern: %1</translation>
    </message>
    <message>
        <source>Interrupted attempts could not be scored. Fulcrum tries again at the next sign-in: %1</source>
        <translation>Unterbrochene Versuche konnten nicht ausgewertet werden. Fulcrum versucht es bei der nächsten Anmeldung erneut: %1</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::CurriculumCard</name>
    <message>
        <source>▲ The move to %1 comes into force on %2: the clock of the station where it was made is ahead of this one.</source>
        <translation>▲ Die Umstellung auf %1 gilt ab %2: Die Uhr der Station, an der sie gemacht wurde, geht gegenüber dieser vor.</translation>
    </message>
    <message>
        <source>Curriculum: %1</source>
        <translation>Curriculum: %1</translation>
    </message>
    <message>
        <source>%1: no longer part of it (now: %2)</source>
        <translation>%1: gehört nicht mehr dazu (jetzt: %2)</translation>
    </message>
    <message>
        <source>%1: added (%2)</source>
        <translation>%1: neu dabei (%2)</translation>
    </message>
    <message>
        <source>%1: %2 → %3</source>
        <translation>%1: %2 → %3</translation>
    </message>
    <message>
        <source>Version of the curriculum</source>
        <translation>Version des Curriculums</translation>
    </message>
    <message>
        <source>What would change</source>
        <translation>Änderungen zeigen</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Umstellen</translation>
    </message>
    <message>
        <source>Curriculum: %1, version %2</source>
        <translation>Curriculum: %1, Version %2</translation>
    </message>
    <message>
        <source>Moved to %1 by %2 on %3: %4</source>
        <translation>Umgestellt auf %1 von %2 am %3: %4</translation>
    </message>
    <message>
        <source>On %1 by a decision of %2 on %3: %4</source>
        <translation>Bei %1 durch eine Entscheidung von %2 am %3: %4</translation>
    </message>
    <message>
        <source>version %1</source>
        <translation>Version %1</translation>
    </message>
    <message>
        <source>No standing changes today. Rules that differ apply to later attempts.</source>
        <translation>Heute ändert sich kein Stand. Abweichende Regeln gelten für spätere Versuche.</translation>
    </message>
    <message>
        <source>Enter a reason.</source>
        <translation>Geben Sie einen Grund an.</translation>
    </message>
    <message>
        <source>Moved to %1. What was passed or declared proficient stays.</source>
        <translation>Umgestellt auf %1. Was bestanden oder für sicher beherrscht erklärt wurde, bleibt.</translation>
    </message>
    <message>
        <source>Reason (kept in the audit log)</source>
        <translation>Grund (steht im Protokoll)</translation>
    </message>
    <message>
        <source>There is a newer version, %1. Each person stays on their version until an educator moves them.</source>
        <translation>Es gibt eine neuere Version, %1. Jede Person bleibt auf ihrer Version, bis ein Ausbilder sie umstellt.</translation>
    </message>
    <message>
        <source>a reason for moving somebody to another version</source>
        <translation>ein Grund für den Wechsel einer Person zu einer anderen Version</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::CurriculumPage</name>
    <message>
        <source>Tasks of the curriculum</source>
        <translation>Aufgaben des Curriculums</translation>
    </message>
    <message>
        <source>Back to the rule in force</source>
        <translation>Zurück zur geltenden Regel</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>%1, version %2</source>
        <translation>%1, Version %2</translation>
    </message>
    <message>
        <source>tried: %1</source>
        <translation>erprobt: %1</translation>
    </message>
    <message>
        <source>Stage %1: %2</source>
        <translation>Stufe %1: %2</translation>
    </message>
    <message>
        <source>open from the start</source>
        <translation>von Anfang an offen</translation>
    </message>
    <message>
        <source>opens after %1</source>
        <translation>öffnet nach %1</translation>
    </message>
    <message numerus="yes">
        <source>passes on %n variants</source>
        <translation>
            <numerusform>Bestandene in %n Variante</numerusform>
            <numerusform>Bestandene in %n Varianten</numerusform>
        </translation>
    </message>
    <message>
        <source>devices: %1</source>
        <translation>Geräte: %1</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message numerus="yes">
        <source>%n ratings with the form %1, mean at least %2</source>
        <translation>
            <numerusform>%n Beurteilung mit dem Bogen %1, Mittelwert mindestens %2</numerusform>
            <numerusform>%n Beurteilungen mit dem Bogen %1, Mittelwert mindestens %2</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Curriculum</source>
        <translation>Curriculum</translation>
    </message>
    <message>
        <source>Stages</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Prerequisites</source>
        <translation>Voraussetzungen</translation>
    </message>
    <message>
        <source>Pass rule</source>
        <translation>Bestehensregel</translation>
    </message>
    <message>
        <source>Variants</source>
        <translation>Varianten</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>Ratings</source>
        <translation>Bewertungen</translation>
    </message>
    <message>
        <source>▲ Up</source>
        <translation>▲ Auf</translation>
    </message>
    <message>
        <source>▼ Down</source>
        <translation>▼ Ab</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Task to be added</source>
        <translation>Aufgabe, die hinzukommt</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Problems of the draft</source>
        <translation>Probleme des Entwurfs</translation>
    </message>
    <message>
        <source>None.</source>
        <translation>Keine.</translation>
    </message>
    <message>
        <source>Publish</source>
        <translation>Veröffentlichen</translation>
    </message>
    <message>
        <source>Reason for the new version</source>
        <translation>Begründung der neuen Version</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Begründung</translation>
    </message>
    <message>
        <source>Discard the draft</source>
        <translation>Entwurf verwerfen</translation>
    </message>
    <message>
        <source>Draft as a file</source>
        <translation>Entwurf als Datei</translation>
    </message>
    <message>
        <source>File of the draft</source>
        <translation>Datei des Entwurfs</translation>
    </message>
    <message>
        <source>Open …</source>
        <translation>Öffnen …</translation>
    </message>
    <message numerus="yes">
        <source>✕ %n problems</source>
        <translation>
            <numerusform>✕ %n Problem</numerusform>
            <numerusform>✕ %n Probleme</numerusform>
        </translation>
    </message>
    <message>
        <source>Publish version %1</source>
        <translation>Version %1 veröffentlichen</translation>
    </message>
    <message>
        <source>An educator publishes, at a station.</source>
        <translation>Eine Lehrperson veröffentlicht, an einer Station.</translation>
    </message>
    <message>
        <source>Solve the problems marked with ✕ first.</source>
        <translation>Lösen Sie zuerst die mit ✕ markierten Probleme.</translation>
    </message>
    <message>
        <source>Give a reason.</source>
        <translation>Geben Sie eine Begründung an.</translation>
    </message>
    <message>
        <source>Draft of a curriculum</source>
        <translation>Entwurf eines Curriculums</translation>
    </message>
    <message>
        <source>Curricula (*.json)</source>
        <translation>Curricula (*.json)</translation>
    </message>
    <message>
        <source>Wrote %1. It is a draft: nothing has changed yet.</source>
        <translation>%1 wurde geschrieben. Es ist ein Entwurf: Noch hat sich nichts geändert.</translation>
    </message>
    <message>
        <source>Version %1 is in force. People who have begun stay on theirs until you move them.</source>
        <translation>Version %1 gilt. Wer begonnen hat, bleibt bei seiner, bis Sie die Person umstellen.</translation>
    </message>
    <message>
        <source>Remedies</source>
        <translation>Abhilfen</translation>
    </message>
    <message>
        <source>The pass rule of a task decides when a trainee is proficient in it. Choose a task, change its rule, and see the effect. Nothing changes for trainees until you publish.</source>
        <translation>Die Bestehensregel einer Aufgabe entscheidet, wann sie sicher beherrscht wird. Wählen Sie eine Aufgabe, ändern Sie die Regel und sehen Sie die Wirkung. Für Lernende ändert sich nichts, bevor Sie veröffentlichen.</translation>
    </message>
    <message>
        <source>Calculated for trainees who pass each attempt with the same probability. Learning, and the days, variants and ratings that a rule can also require, are not included; they make proficiency later.</source>
        <translation>Berechnet für Lernende, die jeden Versuch mit derselben Wahrscheinlichkeit bestehen. Lernen sowie die Tage, Varianten und Beurteilungen, die eine Regel außerdem verlangen kann, sind nicht berücksichtigt; sie verzögern es.</translation>
    </message>
    <message>
        <source>Trainees who have begun keep their version until an educator moves them. Trainees who begin later follow the new version. Your name and reason are kept in the audit log.</source>
        <translation>Lernende, die begonnen haben, behalten ihre Version, bis ein Ausbilder sie umstellt. Lernende, die später beginnen, folgen der neuen. Ihr Name und Ihre Begründung stehen im Protokoll.</translation>
    </message>
    <message>
        <source>Change the draft first; it is the same as the version in force.</source>
        <translation>Ändern Sie zuerst den Entwurf; er gleicht der geltenden Version.</translation>
    </message>
    <message>
        <source>Version %1 is in force and differs from your draft. Decide each of the differences that are listed, then publish.</source>
        <translation>Version %1 gilt und weicht von Ihrem Entwurf ab. Entscheiden Sie jeden der aufgeführten Unterschiede und veröffentlichen Sie dann.</translation>
    </message>
    <message>
        <source>Version %1 is in force. Its changes and yours are in the draft together. Look at it, then publish.</source>
        <translation>Version %1 gilt. Ihre Änderungen und die dieser Version stehen zusammen im Entwurf. Sehen Sie ihn sich an und veröffentlichen Sie dann.</translation>
    </message>
    <message>
        <source>a draft of the curriculum</source>
        <translation>ein Entwurf des Curriculums</translation>
    </message>
    <message>
        <source>Discard it for good</source>
        <translation>Endgültig verwerfen</translation>
    </message>
    <message>
        <source>Open another draft in place of this one</source>
        <translation>Statt dieses Entwurfs einen anderen öffnen</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::DashboardPage</name>
    <message>
        <source>Reading the cohort …</source>
        <translation>Die Gruppe wird gelesen …</translation>
    </message>
    <message>
        <source>Dashboard</source>
        <translation>Übersicht</translation>
    </message>
    <message>
        <source>Cohort</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Weeks that the plan gives for all tasks</source>
        <translation>Wochen, die der Plan für alle Aufgaben vorsieht</translation>
    </message>
    <message>
        <source>The plan: all tasks of the curriculum at an even pace, in so many weeks from a person&apos;s first day of practice on.</source>
        <translation>Der Plan: alle Aufgaben des Curriculums in gleichmäßigem Tempo, in so vielen Wochen ab dem ersten Übungstag der Person.</translation>
    </message>
    <message>
        <source>Plan: </source>
        <translation>Plan: </translation>
    </message>
    <message>
        <source> weeks</source>
        <translation> Wochen</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>There is no cohort yet. A director creates cohorts on the page &quot;Assign cohorts&quot;.</source>
        <translation>Es gibt noch keine Gruppe. Die Programmleitung legt Gruppen auf der Seite „Gruppen zuteilen“ an.</translation>
    </message>
    <message numerus="yes">
        <source>%n people</source>
        <translation>
            <numerusform>%n Person</numerusform>
            <numerusform>%n Personen</numerusform>
        </translation>
    </message>
    <message>
        <source> · deactivated: %1</source>
        <translation> · deaktiviert: %1</translation>
    </message>
    <message>
        <source> · synthetic left out: %1</source>
        <translation> · synthetische ausgelassen: %1</translation>
    </message>
    <message>
        <source> · Click on a part of a picture, or choose it with the arrow keys and press Enter, to see who is behind it.</source>
        <translation> · Klicken Sie auf einen Teil eines Bildes, oder wählen Sie ihn mit den Pfeiltasten und der Eingabetaste, um zu sehen, wer dahintersteht.</translation>
    </message>
    <message>
        <source>There is nobody to show here.</source>
        <translation>Hier gibt es niemanden zu zeigen.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::DashboardTexts</name>
    <message>
        <source>d MMM</source>
        <translation>d. MMM</translation>
    </message>
    <message numerus="yes">
        <source>%n people</source>
        <translation>
            <numerusform>%n Person</numerusform>
            <numerusform>%n Personen</numerusform>
        </translation>
    </message>
    <message>
        <source>overdue</source>
        <translation>überfällig</translation>
    </message>
    <message>
        <source>due now</source>
        <translation>jetzt fällig</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>later</source>
        <translation>später</translation>
    </message>
    <message>
        <source>weeks since the first day of practice</source>
        <translation>Wochen seit dem ersten Übungstag</translation>
    </message>
    <message>
        <source>tasks done</source>
        <translation>erledigte Aufgaben</translation>
    </message>
    <message>
        <source>on plan</source>
        <translation>im Plan</translation>
    </message>
    <message>
        <source>behind it</source>
        <translation>dahinter zurück</translation>
    </message>
    <message numerus="yes">
        <source>plan: all tasks in %n weeks</source>
        <translation>
            <numerusform>Plan: alle Aufgaben in %n Woche</numerusform>
            <numerusform>Plan: alle Aufgaben in %n Wochen</numerusform>
        </translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>Since the first day of practice</source>
        <translation>Seit dem ersten Übungstag</translation>
    </message>
    <message>
        <source>weeks</source>
        <translation>Wochen</translation>
    </message>
    <message>
        <source>Tasks done</source>
        <translation>Erledigte Aufgaben</translation>
    </message>
    <message>
        <source>Tasks by the plan</source>
        <translation>Aufgaben nach Plan</translation>
    </message>
    <message>
        <source>Behind by</source>
        <translation>Rückstand</translation>
    </message>
    <message>
        <source>tasks</source>
        <translation>Aufgaben</translation>
    </message>
    <message>
        <source>%1: week %2, %3 of %4 tasks done, %5 by the plan</source>
        <translation>%1: Woche %2, %3 von %4 Aufgaben erledigt, %5 nach Plan</translation>
    </message>
    <message numerus="yes">
        <source>%n have not begun</source>
        <translation>
            <numerusform>%n hat noch nicht begonnen</numerusform>
            <numerusform>%n haben noch nicht begonnen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 on plan, %2 behind it.</source>
        <translation>%1 im Plan, %2 dahinter zurück.</translation>
    </message>
    <message>
        <source>Nobody has practised yet.</source>
        <translation>Noch hat niemand geübt.</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Tried</source>
        <translation>Versucht</translation>
    </message>
    <message>
        <source>people</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>95 % interval from</source>
        <translation>95-%-Intervall von</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>%1 of %2 (%3 %)</source>
        <translation>%1 von %2 (%3 %)</translation>
    </message>
    <message>
        <source>not tried</source>
        <translation>nicht versucht</translation>
    </message>
    <message>
        <source>People who passed at least once, of those who tried. Line: 95 % interval (Wilson).</source>
        <translation>Personen, die mindestens einmal bestanden haben, von denen, die es versucht haben. Linie: 95-%-Intervall (Wilson).</translation>
    </message>
    <message>
        <source>There is nobody in this cohort.</source>
        <translation>In dieser Gruppe ist niemand.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n people who tried are not there yet</source>
        <translation>
            <numerusform>%1: %n Person, die es versucht hat, ist noch nicht so weit</numerusform>
            <numerusform>%1: %n Personen, die es versucht haben, sind noch nicht so weit</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: fewer than half so far.</source>
        <translation>%1: bisher weniger als die Hälfte.</translation>
    </message>
    <message>
        <source>days since the first attempt that counts</source>
        <translation>Tage seit dem ersten zählenden Versuch</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Since the first attempt</source>
        <translation>Seit dem ersten Versuch</translation>
    </message>
    <message>
        <source>days</source>
        <translation>Tage</translation>
    </message>
    <message>
        <source>Nobody has tried this task yet.</source>
        <translation>Diese Aufgabe hat noch niemand versucht.</translation>
    </message>
    <message>
        <source>first pass</source>
        <translation>zum ersten Mal bestanden</translation>
    </message>
    <message>
        <source>proficient</source>
        <translation>sicher beherrscht</translation>
    </message>
    <message>
        <source>By the method of Kaplan and Meier.</source>
        <translation>Nach dem Verfahren von Kaplan und Meier.</translation>
    </message>
    <message>
        <source>attempts of any kind, by the week&apos;s Monday</source>
        <translation>Versuche jeder Art, nach dem Montag der Woche</translation>
    </message>
    <message>
        <source>Week from</source>
        <translation>Woche ab</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>People who practised</source>
        <translation>Übende</translation>
    </message>
    <message numerus="yes">
        <source>week of %1: %n attempts</source>
        <translation>
            <numerusform>Woche ab %1: %n Versuch</numerusform>
            <numerusform>Woche ab %1: %n Versuche</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempts</source>
        <translation>
            <numerusform>%n Versuch</numerusform>
            <numerusform>%n Versuche</numerusform>
        </translation>
    </message>
    <message>
        <source>in the last %1 weeks.</source>
        <translation>in den letzten %1 Wochen.</translation>
    </message>
    <message>
        <source>checks</source>
        <translation>Überprüfungen</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Wann</translation>
    </message>
    <message>
        <source>Due on</source>
        <translation>Fällig am</translation>
    </message>
    <message numerus="yes">
        <source>%n checks</source>
        <translation>
            <numerusform>%n Überprüfung</numerusform>
            <numerusform>%n Überprüfungen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 overdue, %2 due now, %3 planned.</source>
        <translation>%1 überfällig, %2 jetzt fällig, %3 geplant.</translation>
    </message>
    <message>
        <source>Nobody is proficient yet, so no check is planned.</source>
        <translation>Noch beherrscht niemand eine Aufgabe sicher, deshalb ist keine Überprüfung geplant.</translation>
    </message>
    <message>
        <source>%1: done</source>
        <translation>%1: erledigt</translation>
    </message>
    <message>
        <source>%1: begun</source>
        <translation>%1: begonnen</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>People who got so far</source>
        <translation>So weit gekommen</translation>
    </message>
    <message>
        <source>Share of the cohort</source>
        <translation>Anteil der Gruppe</translation>
    </message>
    <message>
        <source>%1 (%2 %)</source>
        <translation>%1 (%2 %)</translation>
    </message>
    <message>
        <source>Begun: at least one attempt that counts. Done: proficient in every task of the stage, or its rule met by provisional limits.</source>
        <translation>Begonnen: mindestens ein zählender Versuch. Erledigt: jede Aufgabe der Stufe sicher beherrscht, oder ihre Regel mit vorläufigen Grenzen erfüllt.</translation>
    </message>
    <message>
        <source>%1, tried and not passed yet</source>
        <translation>%1, versucht und noch nicht bestanden</translation>
    </message>
    <message>
        <source>Practised in the week of %1</source>
        <translation>Geübt in der Woche ab %1</translation>
    </message>
    <message>
        <source>Checks, %1</source>
        <translation>Überprüfungen, %1</translation>
    </message>
    <message>
        <source>%1, tried and not proficient yet</source>
        <translation>%1, versucht und noch nicht sicher beherrscht</translation>
    </message>
    <message>
        <source>Progress against the plan</source>
        <translation>Fortschritt gegenüber dem Plan</translation>
    </message>
    <message>
        <source>People who passed each task</source>
        <translation>Personen, die jede Aufgabe bestanden haben</translation>
    </message>
    <message>
        <source>Time to proficiency</source>
        <translation>Zeit bis zur sicheren Beherrschung</translation>
    </message>
    <message>
        <source>Attempts each week</source>
        <translation>Versuche je Woche</translation>
    </message>
    <message>
        <source>Retention checks that are due</source>
        <translation>Fällige Überprüfungen</translation>
    </message>
    <message>
        <source>How far people are in the stages</source>
        <translation>Wie weit die Personen in den Stufen sind</translation>
    </message>
    <message>
        <source>%1: half are there after %2 days (95 % interval %3 to %4).</source>
        <translation>%1: die Hälfte nach %2 Tagen (95-%-Intervall %3 bis %4).</translation>
    </message>
    <message>
        <source>%1: half are there after %2 days (95 % interval %3 or more).</source>
        <translation>%1: die Hälfte nach %2 Tagen (95-%-Intervall %3 oder mehr).</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::DebriefPage</name>
    <message>
        <source>← Back</source>
        <translation>← Zurück</translation>
    </message>
    <message>
        <source>Gates</source>
        <translation>Kriterien</translation>
    </message>
    <message>
        <source>All metrics</source>
        <translation>Alle Kennzahlen</translation>
    </message>
    <message>
        <source>Path of both tips</source>
        <translation>Weg beider Spitzen</translation>
    </message>
    <message>
        <source>Corrections</source>
        <translation>Korrekturen</translation>
    </message>
    <message>
        <source>Explain</source>
        <translation>Erklären</translation>
    </message>
    <message>
        <source>Reading the attempt …</source>
        <translation>Versuch wird gelesen …</translation>
    </message>
    <message>
        <source>No picture: %1</source>
        <translation>Kein Bild: %1</translation>
    </message>
    <message>
        <source>Nothing was recorded.</source>
        <translation>Nichts aufgezeichnet.</translation>
    </message>
    <message>
        <source>voided</source>
        <translation>ungültig</translation>
    </message>
    <message>
        <source>Reassigned: recorded under another name and copied to the person who performed it.</source>
        <translation>Neu zugeordnet: unter einem anderen Namen aufgezeichnet und für die Person kopiert, die ihn durchgeführt hat.</translation>
    </message>
    <message>
        <source>Performed by a simulated operator, not by a person.</source>
        <translation>Von einem simulierten Operateur durchgeführt, nicht von einer Person.</translation>
    </message>
    <message>
        <source>Performed in the demonstration, on the account of a synthetic person.</source>
        <translation>In der Vorführung durchgeführt, unter dem Konto einer synthetischen Person.</translation>
    </message>
    <message>
        <source>Not scored: %1</source>
        <translation>Nicht ausgewertet: %1</translation>
    </message>
    <message>
        <source>the attempt has no score</source>
        <translation>der Versuch hat keine Bewertung</translation>
    </message>
    <message>
        <source>, %1</source>
        <translation>, %1</translation>
    </message>
    <message>
        <source>Recomputed on %1 with newer metrics or limits: %2. The score shown stays in force.</source>
        <translation>Am %1 mit neueren Kennzahlen oder Grenzwerten neu berechnet: %2. Die gezeigte Bewertung gilt weiter.</translation>
    </message>
    <message>
        <source>Force was not felt: this device cannot render it. It was shown as bars.</source>
        <translation>Die Kraft war nicht zu spüren: Dieses Gerät kann sie nicht wiedergeben. Sie wurde als Balken gezeigt.</translation>
    </message>
    <message>
        <source>Performed with two mice, for which no limits exist: it is compared with those of mouse and keyboard.</source>
        <translation>Mit zwei Mäusen durchgeführt, für die es keine Grenzwerte gibt: Verglichen wird mit denen für Maus und Tastatur.</translation>
    </message>
    <message>
        <source>%1 samples were lost.</source>
        <translation>%1 Messwerte gingen verloren.</translation>
    </message>
    <message>
        <source>Explain: %1</source>
        <translation>Erklären: %1</translation>
    </message>
    <message>
        <source>To be rated blind: the person&apos;s name, the score and the ratings of others stay hidden until you have handed in your rating.</source>
        <translation>Blind zu beurteilen: Name, Bewertung und die Beurteilungen anderer bleiben verborgen, bis Sie Ihre Beurteilung abgegeben haben.</translation>
    </message>
    <message>
        <source>Compare with another attempt</source>
        <translation>Mit einem anderen Versuch vergleichen</translation>
    </message>
    <message>
        <source>Practice from step %1 of a demonstration: never scored.</source>
        <translation>Übung ab Schritt %1 einer Vorführung: nie ausgewertet.</translation>
    </message>
    <message>
        <source>Practice from the moment %1 of an attempt: never scored.</source>
        <translation>Übung ab dem Zeitpunkt %1 eines Versuchs: nie ausgewertet.</translation>
    </message>
    <message>
        <source>The limits are provisional: they come from simulated experts, not from surgeons. With them a task can be passed, but nobody becomes proficient.</source>
        <translation>Die Grenzwerte sind vorläufig: Sie stammen von simulierten Experten, nicht von Chirurgen. Mit ihnen ist „bestanden“ möglich, nie „sicher beherrscht“.</translation>
    </message>
    <message>
        <source>Limits of the task itself are provisional: no benchmark set of the site has taken them over. With them a task can be passed, but nobody becomes proficient.</source>
        <translation>Grenzwerte der Aufgabe selbst sind vorläufig: Kein Satz des Standorts hat sie übernommen. Mit ihnen ist „bestanden“ möglich, nie „sicher beherrscht“.</translation>
    </message>
    <message>
        <source>Show name and score (my rating is then not blind)</source>
        <translation>Name und Bewertung zeigen (meine Beurteilung ist dann nicht blind)</translation>
    </message>
    <message>
        <source>Fetch the recording</source>
        <translation>Aufzeichnung holen</translation>
    </message>
    <message numerus="yes">
        <source>An educator struck %n errors that the program had recorded. The score stays as it is: scores are never edited. An educator can void the attempt, or decide on the standing.</source>
        <translation>
            <numerusform>%n Fehler, den das Programm aufgezeichnet hatte, wurde gestrichen. Die Punktzahl bleibt, wie sie ist: Bewertungen werden nie bearbeitet. Ein Ausbilder kann den Versuch für ungültig erklären oder über den Stand entscheiden.</numerusform>
            <numerusform>%n Fehler, die das Programm aufgezeichnet hatte, wurden gestrichen. Die Punktzahl bleibt, wie sie ist: Bewertungen werden nie bearbeitet. Ein Ausbilder kann den Versuch für ungültig erklären oder über den Stand entscheiden.</numerusform>
        </translation>
    </message>
    <message>
        <source>No set of limits applies to this attempt. It failed for another reason, such as a critical error, and neither gives nor ends proficiency.</source>
        <translation>Für diesen Versuch gilt kein Satz von Grenzwerten. Er wurde aus einem anderen Grund nicht bestanden, etwa wegen eines kritischen Fehlers, und ändert nichts daran, was sicher beherrscht wird.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::DeviceTest</name>
    <message>
        <source>Connect and try it</source>
        <translation>Verbinden und ausprobieren</translation>
    </message>
    <message>
        <source>Move each hand to the right, up and away from you, one after the other. The dot goes the same way and gets smaller further away; each direction gets a mark.</source>
        <translation>Bewegen Sie jede Hand nacheinander nach rechts, nach oben und von sich weg. Der Punkt geht in dieselbe Richtung und wird in der Ferne kleiner; jede Richtung bekommt ein Häkchen.</translation>
    </message>
    <message>
        <source>Begin again</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>Force test</source>
        <translation>Krafttest</translation>
    </message>
    <message>
        <source>Stop (Esc)</source>
        <translation>Anhalten (Esc)</translation>
    </message>
    <message>
        <source>Rumble</source>
        <translation>Vibrieren</translation>
    </message>
    <message>
        <source>Movement of the instrument</source>
        <translation>Bewegung des Instruments</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Rumble on contact and on too much force</source>
        <translation>Vibrieren bei Berührung und bei zu viel Kraft</translation>
    </message>
    <message>
        <source>Left instrument</source>
        <translation>Linkes Instrument</translation>
    </message>
    <message>
        <source>Right instrument</source>
        <translation>Rechtes Instrument</translation>
    </message>
    <message>
        <source>Scope</source>
        <translation>Optik</translation>
    </message>
    <message>
        <source>left device</source>
        <translation>linkes Gerät</translation>
    </message>
    <message>
        <source>right device</source>
        <translation>rechtes Gerät</translation>
    </message>
    <message>
        <source>third device</source>
        <translation>drittes Gerät</translation>
    </message>
    <message>
        <source>mouse and keyboard</source>
        <translation>Maus und Tastatur</translation>
    </message>
    <message>
        <source>Speed for the same push of a stick, from the next attempt on; 100 %: at most 12 cm/s of the handle.</source>
        <translation>Geschwindigkeit bei gleichem Ausschlag eines Sticks, ab dem nächsten Versuch; 100 %: höchstens 12 cm/s am Griff.</translation>
    </message>
    <message>
        <source>For the same movement of the device, from the next attempt on; 100 %: as far as the hand. Where the instrument begins, the device is at that moment, wherever you hold it.</source>
        <translation>Für dieselbe Bewegung des Geräts, ab dem nächsten Versuch; 100 %: so weit wie die Hand. Das Instrument beginnt dort, wo die Szene es vorsieht, gleich wo Sie das Gerät dann halten.</translation>
    </message>
    <message>
        <source>to the right</source>
        <translation>nach rechts</translation>
    </message>
    <message>
        <source>up</source>
        <translation>nach oben</translation>
    </message>
    <message>
        <source>towards you</source>
        <translation>zu Ihnen hin</translation>
    </message>
    <message>
        <source>%1, %2: %3 N. You feel a gentle push. Press Stop or Esc at any time.</source>
        <translation>%1, %2: %3 N. Sie spüren einen sanften Druck. Anhalten oder Esc geht jederzeit.</translation>
    </message>
    <message>
        <source>Left hand</source>
        <translation>Linke Hand</translation>
    </message>
    <message>
        <source>Right hand</source>
        <translation>Rechte Hand</translation>
    </message>
    <message>
        <source>The test is over: up to %1 N were asked for, up to %2 N rendered. The force is 0.</source>
        <translation>Der Test ist zu Ende: bis zu %1 N wurden verlangt, bis zu %2 N ausgegeben. Die Kraft ist 0.</translation>
    </message>
    <message>
        <source>The test was stopped. The force is 0.</source>
        <translation>Der Test wurde angehalten. Die Kraft ist 0.</translation>
    </message>
    <message>
        <source>Away from you: hold the shoulder button and push the stick up.</source>
        <translation>Von Ihnen weg: Schultertaste halten und den Stick nach oben drücken.</translation>
    </message>
    <message>
        <source>Pedal (energy, suction)</source>
        <translation>Pedal (Energie, Sauger)</translation>
    </message>
    <message>
        <source>button of each hand</source>
        <translation>Taste jeder Hand</translation>
    </message>
    <message>
        <source>button of the left device</source>
        <translation>Taste des linken Geräts</translation>
    </message>
    <message>
        <source>button of the right device</source>
        <translation>Taste des rechten Geräts</translation>
    </message>
    <message>
        <source>button of the third device</source>
        <translation>Taste des dritten Geräts</translation>
    </message>
    <message>
        <source>key or foot switch only</source>
        <translation>nur Tastatur oder Fußschalter</translation>
    </message>
    <message>
        <source>The button of one device is the pedal for both hands. The key of the pedal works with every choice; give it to a foot switch that types a key under Mouse and keys for the hands.</source>
        <translation>Die Taste eines Geräts ist das Pedal für beide Hände. Die Taste der Tastatur für das Pedal wirkt bei jeder Wahl; einem Fußschalter, der eine Taste sendet, geben Sie sie unter „Maus und Tasten für die Hände“.</translation>
    </message>
    <message>
        <source>How far the instrument moves for the same movement of the mouse, from the next attempt. At 100 %, about 3 pixels move the handle by 1 mm.</source>
        <translation>Wie weit sich das Instrument bei derselben Bewegung der Maus bewegt, ab dem nächsten Versuch. Bei 100 % bewegen etwa 3 Pixel den Griff um 1 mm.</translation>
    </message>
    <message>
        <source>While it is held the instrument stays, without force, and you move the handle to a better place.</source>
        <translation>Solange sie gedrückt ist, bleibt das Instrument stehen, ohne Kraft, und Sie bringen den Griff an einen besseren Ort.</translation>
    </message>
    <message>
        <source>Clutch: a button of the device.</source>
        <translation>Kupplung: eine Taste des Geräts.</translation>
    </message>
    <message>
        <source>Clutch: the button for energy, where it is not the pedal.</source>
        <translation>Kupplung: die Taste für Energie, wo sie nicht das Pedal ist.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::DevicesCard</name>
    <message>
        <source>Why: %1</source>
        <translation>Warum: %1</translation>
    </message>
    <message>
        <source>What to do: %1</source>
        <translation>Abhilfe: %1</translation>
    </message>
    <message>
        <source>Left hand</source>
        <translation>Linke Hand</translation>
    </message>
    <message>
        <source>Right hand</source>
        <translation>Rechte Hand</translation>
    </message>
    <message>
        <source>Scope</source>
        <translation>Optik</translation>
    </message>
    <message>
        <source>%1: does not answer</source>
        <translation>%1: antwortet nicht</translation>
    </message>
    <message>
        <source>%1: at (%2, %3, %4) mm, jaws %5 % open, buttons %6</source>
        <translation>%1: bei (%2, %3, %4) mm, Maul zu %5 % offen, Tasten %6</translation>
    </message>
    <message>
        <source>Devices for the hands</source>
        <translation>Geräte für die Hände</translation>
    </message>
    <message>
        <source>Force given to the hand</source>
        <translation>Kraft an der Hand</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Share of the model&apos;s force, from the next attempt on. Each attempt stores it and the debrief names it.</source>
        <translation>Anteil an der Kraft des Modells, ab dem nächsten Versuch. Er wird mit jedem Versuch gespeichert und in seiner Auswertung genannt.</translation>
    </message>
    <message>
        <source>%1 readings per second</source>
        <translation>%1 Messwerte je Sekunde</translation>
    </message>
    <message>
        <source>%1: not connected</source>
        <translation>%1: nicht verbunden</translation>
    </message>
    <message>
        <source>Left stick</source>
        <translation>Linker Stick</translation>
    </message>
    <message>
        <source>Right stick</source>
        <translation>Rechter Stick</translation>
    </message>
    <message>
        <source>%1: %2 % to the right, %3 % up, trigger %4 %</source>
        <translation>%1: %2 % nach rechts, %3 % nach oben, Trigger %4 %</translation>
    </message>
    <message>
        <source>%1: not in its middle since it was connected</source>
        <translation>%1: seit dem Verbinden nicht in der Mitte</translation>
    </message>
    <message>
        <source>It does not rumble.</source>
        <translation>Er vibriert nicht.</translation>
    </message>
    <message>
        <source>In use: %1. It moves the hands from the next attempt on.</source>
        <translation>In Gebrauch: %1. Ab dem nächsten Versuch bewegt es die Hände.</translation>
    </message>
    <message>
        <source>%1 readings per second, at most %2 ms late</source>
        <translation>%1 Messungen pro Sekunde, höchstens %2 ms verspätet</translation>
    </message>
    <message>
        <source>Calibration: needed</source>
        <translation>Kalibrierung: nötig</translation>
    </message>
    <message>
        <source>Calibration: valid</source>
        <translation>Kalibrierung: gültig</translation>
    </message>
    <message>
        <source>Its readings are shown here while it is open: an attempt opens it, or the button below.</source>
        <translation>Seine Messwerte stehen hier, solange es geöffnet ist: Ein Versuch öffnet es oder der Knopf darunter.</translation>
    </message>
    <message>
        <source>Use for the hands</source>
        <translation>Für die Hände verwenden</translation>
    </message>
    <message>
        <source>Use %1 for the hands</source>
        <translation>%1 für die Hände verwenden</translation>
    </message>
    <message>
        <source>Search for devices again</source>
        <translation>Geräte erneut suchen</translation>
    </message>
    <message>
        <source>In use: %1. This device was set when Fulcrum was started (environment variable FULCRUM_DEVICE). Start Fulcrum without it to choose a device here.</source>
        <translation>In Gebrauch: %1. Das Gerät wurde beim Start von Fulcrum festgelegt (Umgebungsvariable FULCRUM_DEVICE). Starten Sie Fulcrum ohne sie, um hier ein Gerät zu wählen.</translation>
    </message>
    <message>
        <source>Jitter of the readings: %1 ms</source>
        <translation>Jitter der Messwerte: %1 ms</translation>
    </message>
    <message>
        <source>Where it is connected and not found: install 70-fulcrum.rules (fulcrum devices shows its lines), then connect it again.</source>
        <translation>Wird es angeschlossen nicht gefunden: installieren Sie 70-fulcrum.rules (fulcrum devices zeigt die Zeilen) und schließen Sie es wieder an.</translation>
    </message>
    <message>
        <source>Versions: %1</source>
        <translation>Versionen: %1</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::DraftMergeCard</name>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>form %1</source>
        <translation>Bogen %1</translation>
    </message>
    <message>
        <source>raters: %1</source>
        <translation>Beurteiler: %1</translation>
    </message>
    <message>
        <source>lowest mean %1</source>
        <translation>Mittelwert mindestens %1</translation>
    </message>
    <message>
        <source>items: %1</source>
        <translation>Punkte: %1</translation>
    </message>
    <message>
        <source>each item</source>
        <translation>jeder Punkt</translation>
    </message>
    <message>
        <source>blind</source>
        <translation>blind</translation>
    </message>
    <message>
        <source>not in it</source>
        <translation>nicht enthalten</translation>
    </message>
    <message>
        <source>in it</source>
        <translation>enthalten</translation>
    </message>
    <message>
        <source>This draft was begun from version %1; version %2 is in force now. Taken from it: %3.</source>
        <translation>Dieser Entwurf ging von Version %1 aus; jetzt gilt Version %2. Daraus übernommen: %3.</translation>
    </message>
    <message>
        <source>This draft was begun from a version %1 that this station does not have. So it cannot be known which of its differences from version %2 are its author&apos;s changes. Exchange with the programme server first and open the draft again, or decide each of them.</source>
        <translation>Dieser Entwurf ging von einer Version %1 aus, die diese Station nicht hat. Deshalb lässt sich nicht sagen, welche Unterschiede zu Version %2 Änderungen seines Verfassers sind. Gleichen Sie zuerst mit dem Programmserver ab und öffnen Sie den Entwurf erneut, oder entscheiden Sie jeden davon.</translation>
    </message>
    <message>
        <source>This draft does not say from which version it was begun: an older program saved it, or it was written elsewhere. So it cannot be known which of its differences from version %1 are its author&apos;s changes, and which were published since. Decide each of them.</source>
        <translation>Dieser Entwurf sagt nicht, von welcher Version er ausging: Ein älteres Programm hat ihn gespeichert, oder er wurde anderswo geschrieben. Deshalb lässt sich nicht sagen, welche Unterschiede zu Version %1 Änderungen seines Verfassers sind und welche seither veröffentlicht wurden. Entscheiden Sie jeden davon.</translation>
    </message>
    <message>
        <source>Title of the curriculum</source>
        <translation>Titel des Curriculums</translation>
    </message>
    <message>
        <source>Order of the stages</source>
        <translation>Reihenfolge der Stufen</translation>
    </message>
    <message>
        <source>Stage %1</source>
        <translation>Stufe %1</translation>
    </message>
    <message>
        <source>Title of stage %1</source>
        <translation>Titel der Stufe %1</translation>
    </message>
    <message>
        <source>Order of the tasks</source>
        <translation>Reihenfolge der Aufgaben</translation>
    </message>
    <message>
        <source>Changes by two authors</source>
        <translation>Änderungen von zweien</translation>
    </message>
    <message>
        <source>Decide each of these; nothing can be published before.</source>
        <translation>Entscheiden Sie jeden dieser Unterschiede; vorher kann nichts veröffentlicht werden.</translation>
    </message>
    <message>
        <source>Keep the draft&apos;s</source>
        <translation>Wie im Entwurf lassen</translation>
    </message>
    <message>
        <source>As in version %1</source>
        <translation>Wie in Version %1</translation>
    </message>
    <message>
        <source>Draft: %1</source>
        <translation>Entwurf: %1</translation>
    </message>
    <message>
        <source>Version %1: %2</source>
        <translation>Version %1: %2</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::ErrorReviewBar</name>
    <message>
        <source>struck by %1: %2</source>
        <translation>gestrichen von %1: %2</translation>
    </message>
    <message>
        <source>confirmed by %1: %2</source>
        <translation>bestätigt von %1: %2</translation>
    </message>
    <message>
        <source>Reason for confirming or striking the error</source>
        <translation>Grund, den Fehler zu bestätigen oder zu streichen</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Confirm</source>
        <translation>Bestätigen</translation>
    </message>
    <message>
        <source>Confirm the chosen error</source>
        <translation>Den gewählten Fehler bestätigen</translation>
    </message>
    <message>
        <source>Strike</source>
        <translation>Streichen</translation>
    </message>
    <message>
        <source>Strike the chosen error</source>
        <translation>Den gewählten Fehler streichen</translation>
    </message>
    <message>
        <source>Choose an error in the list to confirm or strike it.</source>
        <translation>Wählen Sie einen Fehler in der Liste, um ihn zu bestätigen oder zu streichen.</translation>
    </message>
    <message>
        <source>Chosen: %1, %2</source>
        <translation>Gewählt: %1, %2</translation>
    </message>
    <message>
        <source>Give a reason first: the trainee reads it.</source>
        <translation>Geben Sie zuerst einen Grund an: Wer trainiert, liest ihn.</translation>
    </message>
    <message>
        <source>Your reason was kept as a draft of %1.</source>
        <translation>Ihre Begründung wurde als Entwurf zu %1 behalten.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::ExportRow</name>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Format of the report</source>
        <translation>Format des Berichts</translation>
    </message>
    <message>
        <source>File of the report</source>
        <translation>Datei des Berichts</translation>
    </message>
    <message>
        <source>Choose …</source>
        <translation>Wählen …</translation>
    </message>
    <message>
        <source>Reports (*.pdf *.csv *.xlsx *.json)</source>
        <translation>Berichte (*.pdf *.csv *.xlsx *.json)</translation>
    </message>
    <message>
        <source>Save report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>Replace report</source>
        <translation>Bericht ersetzen</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::FigureChart</name>
    <message>
        <source>Arrow keys choose a part, Enter shows what is behind it.</source>
        <translation>Pfeiltasten wählen einen Teil, die Eingabetaste zeigt, was dahinter steht.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::FirstStartPage</name>
    <message>
        <source>a programme that is not created yet</source>
        <translation>ein Programm, das noch nicht angelegt ist</translation>
    </message>
    <message>
        <source>A simulator for laparoscopic rectal surgery with its training programme: tasks, scores with their evidence, reviews and reports.</source>
        <translation>Ein Simulator für die laparoskopische Rektumchirurgie mit seinem Ausbildungsprogramm: Aufgaben, Bewertungen mit ihren Belegen, Durchsichten und Berichte.</translation>
    </message>
    <message>
        <source>Create programme</source>
        <translation>Programm anlegen</translation>
    </message>
    <message>
        <source>Look around</source>
        <translation>Umsehen</translation>
    </message>
    <message>
        <source>Programme</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>for example: Department of Surgery</source>
        <translation>zum Beispiel: Klinik für Chirurgie</translation>
    </message>
    <message>
        <source>Your name</source>
        <translation>Ihr Name</translation>
    </message>
    <message>
        <source>Your login</source>
        <translation>Ihr Anmeldename</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Passwort</translation>
    </message>
    <message>
        <source>at least %1 characters</source>
        <translation>mindestens %1 Zeichen</translation>
    </message>
    <message>
        <source>Password again</source>
        <translation>Passwort wiederholen</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Your recovery code</source>
        <translation>Ihr Wiederherstellungscode</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>I have written it down</source>
        <translation>Ich habe ihn aufgeschrieben</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>The two passwords are not the same.</source>
        <translation>Die beiden Passwörter stimmen nicht überein.</translation>
    </message>
    <message>
        <source>The password needs at least %1 characters.</source>
        <translation>Das Passwort braucht mindestens %1 Zeichen.</translation>
    </message>
    <message>
        <source>Creating the programme …</source>
        <translation>Programm wird angelegt …</translation>
    </message>
    <message>
        <source>Unpacking the demonstration programme …</source>
        <translation>Das Vorführprogramm wird entpackt …</translation>
    </message>
    <message>
        <source>For a department or a training centre. You become its first administrator and then add people, roles and cohorts.</source>
        <translation>Für eine Abteilung oder ein Ausbildungszentrum. Sie werden der erste Administrator und fügen dann Personen, Rollen und Gruppen hinzu.</translation>
    </message>
    <message>
        <source>A demonstration programme: 24 simulated trainees after 12 weeks of training. The people are not real; their attempts were simulated in full. You can practise, and every screen has content.</source>
        <translation>Ein Vorführprogramm: 24 simulierte Lernende nach 12 Wochen Ausbildung. Die Personen sind nicht echt; ihre Versuche wurden vollständig simuliert. Sie können üben, und jede Seite hat Inhalt.</translation>
    </message>
    <message>
        <source>Letters, digits and . _ - @</source>
        <translation>Buchstaben, Ziffern und . _ - @</translation>
    </message>
    <message>
        <source>This code is shown only once. Write it down and lock it away: without it, the last administrator cannot set a new password.</source>
        <translation>Dieser Code wird nur einmal gezeigt. Schreiben Sie ihn auf und schließen Sie ihn weg: Ohne ihn kann der letzte Administrator kein neues Passwort setzen.</translation>
    </message>
    <message>
        <source>Is this a further station of a programme that has a server? Join it with a token of the server&apos;s owner.</source>
        <translation>Ist dies eine weitere Station eines Programms, das einen Server hat? Treten Sie ihm mit einem Token vom Eigentümer des Servers bei.</translation>
    </message>
    <message>
        <source>Join a programme</source>
        <translation>Einem Programm beitreten</translation>
    </message>
    <message>
        <source>Is there a backup of a programme, from this machine or another one?</source>
        <translation>Gibt es eine Sicherung eines Programms, von diesem Rechner oder einem anderen?</translation>
    </message>
    <message>
        <source>Restore a backup</source>
        <translation>Sicherung wiederherstellen</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::FrameCheck</name>
    <message>
        <source>Left hand</source>
        <translation>Linke Hand</translation>
    </message>
    <message>
        <source>Right hand</source>
        <translation>Rechte Hand</translation>
    </message>
    <message>
        <source>Scope</source>
        <translation>Optik</translation>
    </message>
    <message>
        <source>Where the hands are</source>
        <translation>Wo die Hände sind</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>up</source>
        <translation>nach oben</translation>
    </message>
    <message>
        <source>away from you</source>
        <translation>von Ihnen weg</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::GatesCard</name>
    <message>
        <source>Gates</source>
        <translation>Kriterien</translation>
    </message>
    <message>
        <source>Gate</source>
        <translation>Kriterium</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Hand</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Grenzwert</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Bedeutung</translation>
    </message>
    <message>
        <source>Source of the limit</source>
        <translation>Quelle des Grenzwerts</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>– not assessed</source>
        <translation>– nicht bewertet</translation>
    </message>
    <message>
        <source>✓ met</source>
        <translation>✓ erfüllt</translation>
    </message>
    <message>
        <source>✕ not met</source>
        <translation>✕ nicht erfüllt</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>provisional: %1</source>
        <translation>vorläufig: %1</translation>
    </message>
    <message>
        <source>%1 (limit provisional)</source>
        <translation>%1 (Grenzwert vorläufig)</translation>
    </message>
    <message>
        <source>A gate is a pass criterion: every gate must be met. z: standard deviations from the experts&apos; mean. Select a row to go to the moment that decided it, or Explain to read what is measured.</source>
        <translation>Jedes Kriterium muss erfüllt sein. z: Standardabweichungen vom Mittelwert der Experten. Wählen Sie eine Zeile, um zum entscheidenden Zeitpunkt zu springen, oder „Erklären“, um zu lesen, was gemessen wird.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Source of each limit</source>
        <translation>Herkunft der Grenzwerte</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::GoalsCard</name>
    <message>
        <source>Your goals</source>
        <translation>Ihre Ziele</translation>
    </message>
    <message>
        <source>Goals that the trainee set</source>
        <translation>Selbst gesetzte Ziele</translation>
    </message>
    <message>
        <source>Set a goal</source>
        <translation>Ein Ziel setzen</translation>
    </message>
    <message>
        <source>Kind of goal</source>
        <translation>Art des Ziels</translation>
    </message>
    <message>
        <source>Attempts a week</source>
        <translation>Versuche pro Woche</translation>
    </message>
    <message>
        <source>Value of a metric</source>
        <translation>Wert einer Kennzahl</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Kennzahl</translation>
    </message>
    <message>
        <source>Goal</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>by</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>Day by which it is reached</source>
        <translation>Tag, bis zu dem es erreicht ist</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Ändern</translation>
    </message>
    <message>
        <source>Any task</source>
        <translation>Jede Aufgabe</translation>
    </message>
    <message>
        <source>Your latest value: %1. Of both hands the worse one counts.</source>
        <translation>Ihr letzter Wert: %1. Von beiden Händen zählt die schlechtere.</translation>
    </message>
    <message>
        <source>You have no completed attempt with this metric yet.</source>
        <translation>Sie haben noch keinen abgeschlossenen Versuch mit dieser Kennzahl.</translation>
    </message>
    <message>
        <source>Set a goal for yourself: a number of attempts a week, or a value of a metric by a date. Only you and your educators see it.</source>
        <translation>Setzen Sie sich ein eigenes Ziel: eine Anzahl von Versuchen pro Woche oder den Wert einer Kennzahl bis zu einem Datum. Nur Sie und Ihre Ausbilder sehen es.</translation>
    </message>
    <message>
        <source>Remove goal</source>
        <translation>Ziel entfernen</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::HeadlineTexts</name>
    <message>
        <source>no score</source>
        <translation>keine Bewertung</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>All %1 steps done.</source>
        <translation>Alle %1 Schritte erledigt.</translation>
    </message>
    <message>
        <source>%1 of %2 steps done. Left: %3.</source>
        <translation>%1 von %2 Schritten erledigt. Offen: %3.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Left hand path</source>
        <translation>Weg der linken Hand</translation>
    </message>
    <message>
        <source>Right hand path</source>
        <translation>Weg der rechten Hand</translation>
    </message>
    <message>
        <source>Damage</source>
        <translation>Schaden</translation>
    </message>
    <message>
        <source>force over the tissue&apos;s limit × time</source>
        <translation>Kraft über dem Grenzwert des Gewebes × Zeit</translation>
    </message>
    <message>
        <source>critical: %1</source>
        <translation>kritisch: %1</translation>
    </message>
    <message>
        <source>The recording of this attempt was not kept, so there is no replay and there are no charts. The result and the scores are kept.</source>
        <translation>Die Aufzeichnung dieses Versuchs wurde nicht behalten; darum gibt es keine Wiedergabe und keine Kurven. Ergebnis und Bewertungen sind erhalten.</translation>
    </message>
    <message>
        <source>External attempt, recorded by: %1. Its metrics are shown, but there is no scene to replay. It is not compared with limits and does not count in the curriculum.</source>
        <translation>Externer Versuch, aufgezeichnet von: %1. Seine Kennzahlen werden gezeigt, aber es gibt keine Szene für eine Wiedergabe. Er wird nicht mit Grenzwerten verglichen und zählt nicht im Curriculum.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::HomePage</name>
    <message>
        <source>You follow the curriculum %1, which is not at this station. Your standing cannot be shown here, and only practice is possible until an administrator exchanges with the programme server or installs it.</source>
        <translation>Sie folgen dem Curriculum %1, das an dieser Station fehlt. Ihr Stand lässt sich hier nicht zeigen, und nur Üben ist möglich, bis ein Administrator mit dem Server des Programms abgleicht oder es installiert.</translation>
    </message>
    <message>
        <source>Reading your attempts …</source>
        <translation>Ihre Versuche werden gelesen …</translation>
    </message>
    <message>
        <source>Your attempts could not be read: %1</source>
        <translation>Ihre Versuche konnten nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>Your tasks appear here once they are read. If trying again does not help, ask an administrator to check the store (page Station).</source>
        <translation>Ihre Aufgaben erscheinen hier, sobald sie gelesen sind. Hilft es nicht, es noch einmal zu versuchen, bitten Sie einen Administrator, den Datenbestand zu prüfen (Seite Station).</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Noch einmal versuchen</translation>
    </message>
    <message>
        <source>Other exercises</source>
        <translation>Weitere Aufgaben</translation>
    </message>
    <message>
        <source>Hello, %1</source>
        <translation>Guten Tag, %1</translation>
    </message>
    <message>
        <source>Open the briefing</source>
        <translation>Einweisung öffnen</translation>
    </message>
    <message>
        <source>%1, %2, %3 recorded: </source>
        <translation>%1, %2, %3 aufgezeichnet: </translation>
    </message>
    <message>
        <source>failed: a limit was exceeded before the interruption</source>
        <translation>nicht bestanden: Vor der Unterbrechung wurde ein Grenzwert überschritten</translation>
    </message>
    <message>
        <source>does not count (%1)</source>
        <translation>zählt nicht (%1)</translation>
    </message>
    <message>
        <source>Unread comments: %1</source>
        <translation>Ungelesene Kommentare: %1</translation>
    </message>
    <message>
        <source>%1 at %2: %3</source>
        <translation>%1 bei %2: %3</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1 of %2 attempts passed</source>
        <translation>%1 von %2 Versuchen bestanden</translation>
    </message>
    <message>
        <source>best %1</source>
        <translation>Bestwert %1</translation>
    </message>
    <message>
        <source>Briefing</source>
        <translation>Einweisung</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Watch an expert do it</source>
        <translation>Einem Experten zusehen</translation>
    </message>
    <message>
        <source>Open the replay</source>
        <translation>Wiedergabe öffnen</translation>
    </message>
    <message>
        <source>Recommended next</source>
        <translation>Als Nächstes empfohlen</translation>
    </message>
    <message>
        <source>Attempts interrupted before you signed in: %1</source>
        <translation>Versuche, die vor Ihrer Anmeldung unterbrochen wurden: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n do not count</source>
        <translation>
            <numerusform>%n zählt nicht</numerusform>
            <numerusform>%n zählen nicht</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::HudTexts</name>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>zu</translation>
    </message>
    <message>
        <source>open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>jaws closed</source>
        <translation>Maul zu</translation>
    </message>
    <message>
        <source>jaws open</source>
        <translation>Maul offen</translation>
    </message>
    <message>
        <source>%1 next · %2 pedal</source>
        <translation>%1 nächstes · %2 Pedal</translation>
    </message>
    <message>
        <source>⚠ less</source>
        <translation>⚠ weniger</translation>
    </message>
    <message>
        <source>⚠ less force</source>
        <translation>⚠ weniger Kraft</translation>
    </message>
    <message>
        <source>%1 of %2 targets</source>
        <translation>%1 von %2 Zielen</translation>
    </message>
    <message>
        <source>%1 of %2 cm</source>
        <translation>%1 von %2 cm</translation>
    </message>
    <message>
        <source>%1 of %2 s held</source>
        <translation>%1 von %2 s gehalten</translation>
    </message>
    <message>
        <source>%1 of %2 mm high</source>
        <translation>%1 von %2 mm hoch</translation>
    </message>
    <message>
        <source>%1 of %2 mm, %3 mm torn</source>
        <translation>%1 von %2 mm, %3 mm gerissen</translation>
    </message>
    <message>
        <source>%1 of %2 mm</source>
        <translation>%1 von %2 mm</translation>
    </message>
    <message>
        <source>%1 of %2 bands, %3 torn · %4 mL lost</source>
        <translation>%1 von %2 Strängen, %3 gerissen · %4 mL verloren</translation>
    </message>
    <message>
        <source>%1 of %2 bands · %3 mL lost</source>
        <translation>%1 von %2 Strängen · %3 mL verloren</translation>
    </message>
    <message>
        <source>%1 of %2 vessels controlled · %3 mL lost</source>
        <translation>%1 von %2 Gefäßen versorgt · %3 mL verloren</translation>
    </message>
    <message>
        <source>%1 of %2 rings</source>
        <translation>%1 von %2 Ringen</translation>
    </message>
    <message>
        <source>%1 of %2 s framed</source>
        <translation>%1 von %2 s im Bild</translation>
    </message>
    <message>
        <source>%1 of %2 s in contact</source>
        <translation>%1 von %2 s in Kontakt</translation>
    </message>
    <message>
        <source>%1 of %2 s free</source>
        <translation>%1 von %2 s frei</translation>
    </message>
    <message>
        <source>⚠ look for the lit ball</source>
        <translation>⚠ leuchtende Kugel suchen</translation>
    </message>
    <message>
        <source>⚠ look into the cup</source>
        <translation>⚠ in den Becher blicken</translation>
    </message>
    <message>
        <source>⚠ to the middle</source>
        <translation>⚠ zur Mitte</translation>
    </message>
    <message>
        <source>⚠ nearer</source>
        <translation>⚠ näher</translation>
    </message>
    <message>
        <source>⚠ further away</source>
        <translation>⚠ weiter weg</translation>
    </message>
    <message>
        <source>⚠ level the horizon</source>
        <translation>⚠ Horizont ausrichten</translation>
    </message>
    <message>
        <source>⚠ less traction</source>
        <translation>⚠ weniger Zug</translation>
    </message>
    <message>
        <source>⚠ more traction</source>
        <translation>⚠ mehr Zug</translation>
    </message>
    <message>
        <source>⚠ %1 mm off the line</source>
        <translation>⚠ %1 mm neben der Linie</translation>
    </message>
    <message>
        <source>clips: %1</source>
        <translation>Clips: %1</translation>
    </message>
    <message>
        <source>, in %1 s</source>
        <translation>, in %1 s</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>noch %1</translation>
    </message>
    <message>
        <source>practice: it was interrupted</source>
        <translation>Übung: wurde unterbrochen</translation>
    </message>
    <message>
        <source>assessed</source>
        <translation>bewertet</translation>
    </message>
    <message>
        <source>practice</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Schritt %1 von %2</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>halten</translation>
    </message>
    <message>
        <source>traction %1 of %2–%3 N/m</source>
        <translation>Zug %1 von %2–%3 N/m</translation>
    </message>
    <message>
        <source>force is shown, not felt</source>
        <translation>Kraft wird angezeigt, nicht gefühlt</translation>
    </message>
    <message>
        <source>Esc pause · F1 help</source>
        <translation>Esc Pause · F1 Hilfe</translation>
    </message>
    <message>
        <source>✕ critical error</source>
        <translation>✕ kritischer Fehler</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::ImportCard</name>
    <message>
        <source>Reading the list …</source>
        <translation>Die Liste wird gelesen …</translation>
    </message>
    <message>
        <source>new account</source>
        <translation>neues Konto</translation>
    </message>
    <message>
        <source>gets a role</source>
        <translation>erhält eine Rolle</translation>
    </message>
    <message>
        <source>not imported: the account is deactivated</source>
        <translation>nicht importiert: Das Konto ist deaktiviert</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Login</source>
        <translation>Anmeldename</translation>
    </message>
    <message>
        <source>Roles</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>One-time passwords</source>
        <translation>Einmalpasswörter</translation>
    </message>
    <message>
        <source>New file for the one-time passwords</source>
        <translation>Neue Datei für die Einmalpasswörter</translation>
    </message>
    <message>
        <source>File or folder of the list</source>
        <translation>Datei oder Ordner der Liste</translation>
    </message>
    <message>
        <source>File …</source>
        <translation>Datei …</translation>
    </message>
    <message>
        <source>Folder …</source>
        <translation>Ordner …</translation>
    </message>
    <message>
        <source>List of people</source>
        <translation>Liste von Personen</translation>
    </message>
    <message>
        <source>left out: %1</source>
        <translation>ausgelassen: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n new accounts</source>
        <translation>
            <numerusform>%n neues Konto</numerusform>
            <numerusform>%n neue Konten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n people get a role</source>
        <translation>
            <numerusform>%n Person erhält eine Rolle</numerusform>
            <numerusform>%n Personen erhalten eine Rolle</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n are there already</source>
        <translation>
            <numerusform>%n ist schon da</numerusform>
            <numerusform>%n sind schon da</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n left out</source>
        <translation>
            <numerusform>%n ausgelassen</numerusform>
            <numerusform>%n ausgelassen</numerusform>
        </translation>
    </message>
    <message>
        <source>Stopped. The accounts that were made have their passwords in the file; an import of the same list makes the others.</source>
        <translation>Abgebrochen. Die Passwörter der angelegten Konten stehen in der Datei; ein Import derselben Liste legt die übrigen an.</translation>
    </message>
    <message>
        <source>Making accounts …</source>
        <translation>Konten werden angelegt …</translation>
    </message>
    <message numerus="yes">
        <source>%n accounts were made.</source>
        <translation>
            <numerusform>%n Konto wurde angelegt.</numerusform>
            <numerusform>%n Konten wurden angelegt.</numerusform>
        </translation>
    </message>
    <message>
        <source>Their one-time passwords are in %1, valid for 24 hours. Hand them over and delete the file.</source>
        <translation>Ihre Einmalpasswörter stehen in %1 und gelten 24 Stunden. Geben Sie sie weiter und löschen Sie die Datei.</translation>
    </message>
    <message>
        <source>CSV or ZIP (*.csv *.zip)</source>
        <translation>CSV oder ZIP (*.csv *.zip)</translation>
    </message>
    <message>
        <source>exists already</source>
        <translation>ist schon vorhanden</translation>
    </message>
    <message>
        <source>Import people from a list</source>
        <translation>Personen aus einer Liste importieren</translation>
    </message>
    <message>
        <source>Choose a folder or ZIP archive with OneRoster CSV files, or one CSV file with the columns login, name, role and cohort. The import only adds accounts and roles; it renames, deactivates and removes nobody.</source>
        <translation>Einen Ordner oder ein ZIP-Archiv mit OneRoster-CSV-Dateien wählen, oder eine CSV-Datei mit den Spalten login, name, role und cohort. Der Import fügt nur Konten und Rollen hinzu; er benennt niemanden um, deaktiviert und entfernt niemanden.</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::ItemChoice</name>
    <message>
        <source>not seen</source>
        <translation>nicht gesehen</translation>
    </message>
    <message>
        <source>this was not seen</source>
        <translation>das war nicht zu sehen</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::JobBar</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::JoinForm</name>
    <message>
        <source>a programme that is not joined yet</source>
        <translation>ein Programm, dem diese Station noch nicht beigetreten ist</translation>
    </message>
    <message>
        <source>Join a programme</source>
        <translation>Einem Programm beitreten</translation>
    </message>
    <message>
        <source>The owner of the programme server makes a token for this station with &quot;fulcrum server enrol&quot; and tells you the server&apos;s address. People sign in here with the passwords that they have at the other stations.</source>
        <translation>Der Eigentümer des Programmservers erzeugt mit „fulcrum server enrol“ ein Token für diese Station und nennt Ihnen die Adresse des Servers. Hier melden sich alle mit dem Passwort an, das sie an den anderen Stationen haben.</translation>
    </message>
    <message>
        <source>Server</source>
        <translation>Server</translation>
    </message>
    <message>
        <source>Token</source>
        <translation>Token</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>Beitreten</translation>
    </message>
    <message>
        <source>Fetching the programme …</source>
        <translation>Das Programm wird geholt …</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::JudgedCard</name>
    <message>
        <source>more than %1</source>
        <translation>mehr als %1</translation>
    </message>
    <message>
        <source>less than %1</source>
        <translation>weniger als %1</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>mindestens %1</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>höchstens %1</translation>
    </message>
    <message>
        <source>What is assessed</source>
        <translation>Was bewertet wird</translation>
    </message>
    <message>
        <source>Show as a list</source>
        <translation>Als Liste zeigen</translation>
    </message>
    <message>
        <source>Show as bars</source>
        <translation>Als Balken zeigen</translation>
    </message>
    <message>
        <source>Critical errors (the attempt fails): %1</source>
        <translation>Kritische Fehler (der Versuch ist nicht bestanden): %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>; experts %1 to %2</source>
        <translation>; Experten %1 bis %2</translation>
    </message>
    <message>
        <source> (provisional)</source>
        <translation> (vorläufig)</translation>
    </message>
    <message>
        <source>Explain</source>
        <translation>Erklären</translation>
    </message>
    <message>
        <source>Explain: %1</source>
        <translation>Erklären: %1</translation>
    </message>
    <message>
        <source>Line: the limit. Green: values that meet it. Box: experts (mean ± one standard deviation). Diamond: your last value with this device. * Provisional limit.</source>
        <translation>Strich: der Grenzwert. Grün: Werte, die ihn erfüllen. Kasten: Experten (Mittelwert ± eine Standardabweichung). Raute: Ihr letzter Wert mit diesem Gerät. * Vorläufiger Grenzwert.</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>kein Grenzwert</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::KeysCard</name>
    <message>
        <source>Mouse and keys for the hands</source>
        <translation>Maus und Tasten für die Hände</translation>
    </message>
    <message>
        <source>Mouse in the right hand</source>
        <translation>Maus in der rechten Hand</translation>
    </message>
    <message>
        <source>Mouse in the left hand</source>
        <translation>Maus in der linken Hand</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <translation>%1, %2: %3</translation>
    </message>
    <message>
        <source>Press the new key for “%1”, or Escape.</source>
        <translation>Drücken Sie die neue Taste für „%1“, oder Escape.</translation>
    </message>
    <message>
        <source>This key is needed for something else. Press another one, or Escape.</source>
        <translation>Diese Taste wird für anderes gebraucht. Drücken Sie eine andere, oder Escape.</translation>
    </message>
    <message>
        <source>%1 is already used (%2: %3). Press another key, or Escape and change that one first.</source>
        <translation>%1 ist schon vergeben (%2: %3). Drücken Sie eine andere Taste, oder Escape und ändern Sie zuerst jene.</translation>
    </message>
    <message>
        <source>Saved for you on this computer. A change applies from the next attempt. The keys are shown when an attempt begins, and when you press F1.</source>
        <translation>Für Sie auf diesem Rechner gespeichert. Eine Änderung gilt ab dem nächsten Versuch. Die Tasten werden am Beginn eines Versuchs und mit F1 gezeigt.</translation>
    </message>
    <message>
        <source>With the mouse in the left hand, its two buttons are swapped, and the keys of the mouse&apos;s hand move to the right side of the keyboard. This choice resets all keys.</source>
        <translation>Mit der Maus in der linken Hand sind ihre beiden Tasten vertauscht, und die Tasten der Maushand liegen rechts auf der Tastatur. Diese Wahl setzt alle Tasten zurück.</translation>
    </message>
    <message>
        <source>Reset all keys</source>
        <translation>Alle Tasten zurücksetzen</translation>
    </message>
    <message>
        <source>This key has no name under which it could be kept. Press another one, or Escape.</source>
        <translation>Diese Taste hat keinen Namen, unter dem sie gespeichert werden könnte. Drücken Sie eine andere, oder Escape.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::Ladder</name>
    <message>
        <source>Your progress through the curriculum</source>
        <translation>Ihr Fortschritt im Curriculum</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::LimitBar</name>
    <message>
        <source>experts %1 to %2</source>
        <translation>Experten %1 bis %2</translation>
    </message>
    <message>
        <source>your last value %1</source>
        <translation>Ihr letzter Wert %1</translation>
    </message>
    <message>
        <source>no value of yours yet</source>
        <translation>noch kein Wert von Ihnen</translation>
    </message>
    <message>
        <source>you: %1</source>
        <translation>Sie: %1</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::LimitsChart</name>
    <message>
        <source>Limits of each set, gate by gate</source>
        <translation>Grenzwerte jedes Satzes, Kriterium für Kriterium</translation>
    </message>
    <message>
        <source>at least; %1 to %2</source>
        <translation>mindestens; %1 bis %2</translation>
    </message>
    <message>
        <source>at most; %1 to %2</source>
        <translation>höchstens; %1 bis %2</translation>
    </message>
    <message>
        <source>Experts and trainees, and the mark between them</source>
        <translation>Experten und Lernende und die Grenze dazwischen</translation>
    </message>
    <message>
        <source>experts of the set</source>
        <translation>Experten des Satzes</translation>
    </message>
    <message>
        <source>attempts here</source>
        <translation>Versuche hier</translation>
    </message>
    <message>
        <source>Gate</source>
        <translation>Kriterium</translation>
    </message>
    <message>
        <source>Limit of the set or attempt</source>
        <translation>Grenze des Satzes oder Versuch</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>limit of set %1</source>
        <translation>Grenze des Satzes %1</translation>
    </message>
    <message>
        <source>attempt</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Geometric mean, or mark</source>
        <translation>Geometrisches Mittel oder Marke</translation>
    </message>
    <message>
        <source>Mean, or mark</source>
        <translation>Mittelwert oder Marke</translation>
    </message>
    <message>
        <source>Geometric standard deviation</source>
        <translation>Geometrische Standardabweichung</translation>
    </message>
    <message>
        <source>Standard deviation</source>
        <translation>Standardabweichung</translation>
    </message>
    <message>
        <source>mark between them</source>
        <translation>Marke dazwischen</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::LimitsPage</name>
    <message>
        <source>Reading the attempts …</source>
        <translation>Die Versuche werden gelesen …</translation>
    </message>
    <message>
        <source>%1 of %2 (%3 %)</source>
        <translation>%1 von %2 (%3 %)</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenzwerte</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Satz</translation>
    </message>
    <message>
        <source>Made from</source>
        <translation>Grundlage</translation>
    </message>
    <message>
        <source>Experts</source>
        <translation>Experten</translation>
    </message>
    <message>
        <source>Experts pass</source>
        <translation>Experten bestehen</translation>
    </message>
    <message>
        <source>Would pass</source>
        <translation>Würden bestehen</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Set in force</source>
        <translation>Geltender Satz</translation>
    </message>
    <message>
        <source>Compare with a set in a file</source>
        <translation>Mit einem Satz aus einer Datei vergleichen</translation>
    </message>
    <message>
        <source>File of a benchmark set</source>
        <translation>Datei eines Vergleichssatzes</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Pass mark between two groups</source>
        <translation>Bestehensgrenze zwischen zwei Gruppen</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Kennzahl</translation>
    </message>
    <message>
        <source>%1 holds the set %2; this page compares sets of %3. Choose its task and devices above first.</source>
        <translation>%1 enthält den Satz %2; diese Seite vergleicht Sätze von %3. Wählen Sie zuerst oben dessen Aufgabe und Geräte.</translation>
    </message>
    <message>
        <source>There is no set of limits for this task.</source>
        <translation>Für diese Aufgabe gibt es keinen Satz von Grenzwerten.</translation>
    </message>
    <message>
        <source>No attempt stored here counts under these limits yet.</source>
        <translation>Noch zählt kein hier gespeicherter Versuch unter diesen Grenzwerten.</translation>
    </message>
    <message>
        <source>, not judged: %1</source>
        <translation>, nicht beurteilt: %1</translation>
    </message>
    <message>
        <source>in force (%1)</source>
        <translation>geltend (%1)</translation>
    </message>
    <message>
        <source>version %1</source>
        <translation>Version %1</translation>
    </message>
    <message>
        <source>A pass mark needs at least %1 attempts with this value; there are %2.</source>
        <translation>Eine Bestehensgrenze braucht mindestens %1 Versuche mit diesem Wert; es gibt %2.</translation>
    </message>
    <message>
        <source>All attempts have the same value.</source>
        <translation>Alle Versuche haben denselben Wert.</translation>
    </message>
    <message>
        <source>No pass mark: the groups overlap.</source>
        <translation>Keine Bestehensgrenze: Die Gruppen überdecken sich.</translation>
    </message>
    <message>
        <source>No pass mark: the attempts here are better than those of the set&apos;s experts. The limit in force is %1.</source>
        <translation>Keine Bestehensgrenze: Die Versuche hier sind besser als die der Experten des Satzes. Der geltende Grenzwert ist %1.</translation>
    </message>
    <message>
        <source>The limits that attempts are compared with, and how many people would pass with other limits. This page changes nothing.</source>
        <translation>Die Grenzwerte, mit denen Versuche verglichen werden, und wie viele Personen mit anderen bestehen würden. Diese Seite ändert nichts.</translation>
    </message>
    <message>
        <source>Limits of each benchmark set</source>
        <translation>Grenzwerte jedes Satzes</translation>
    </message>
    <message>
        <source>Who would pass with each set</source>
        <translation>Wer mit welchem Satz bestehen würde</translation>
    </message>
    <message>
        <source>A file made by the command &quot;fulcrum benchmark build&quot;</source>
        <translation>Eine Datei, die der Befehl „fulcrum benchmark build“ erstellt hat</translation>
    </message>
    <message>
        <source>The contrasting-groups method: the value at which an attempt is equally likely to come from the set&apos;s experts and from the attempts stored here, if both are normally distributed.</source>
        <translation>Das Verfahren der kontrastierenden Gruppen: der Wert, bei dem ein Versuch ebenso wahrscheinlich von den Experten des Satzes stammt wie von den hier gespeicherten Versuchen, wenn beide normalverteilt sind.</translation>
    </message>
    <message>
        <source>Each dot is an attempt that counts. Attempts: %1, people: %2; at most the newest %3 attempts.</source>
        <translation>Jeder Punkt ist ein Versuch, der zählt. Versuche: %1, Personen: %2; höchstens die neuesten %3 Versuche.</translation>
    </message>
    <message>
        <source>Pass mark: %1. With it, %2 % of the attempts here would pass and %3 % of the experts&apos; attempts would fail. The limit in force is %4.</source>
        <translation>Bestehensgrenze: %1. Damit wären %2 % der Versuche hier bestanden und %3 % der Versuche der Experten nicht bestanden. Der geltende Grenzwert ist %4.</translation>
    </message>
    <message>
        <source>%1 (limit of the task: %2)</source>
        <translation>%1 (Grenzwert der Aufgabe: %2)</translation>
    </message>
    <message>
        <source>%1: more than %2</source>
        <translation>%1: mehr als %2</translation>
    </message>
    <message>
        <source>%1: less than %2</source>
        <translation>%1: weniger als %2</translation>
    </message>
    <message>
        <source>%1: at least %2</source>
        <translation>%1: mindestens %2</translation>
    </message>
    <message>
        <source>%1: at most %2</source>
        <translation>%1: höchstens %2</translation>
    </message>
    <message>
        <source> (changed by an update since version %1 took it over)</source>
        <translation> (durch ein Update geändert, seit Version %1 ihn übernommen hat)</translation>
    </message>
    <message>
        <source>Provisional limits of the task that version %1 of the set does not take over: %2. Attempts are passed provisionally, and nobody becomes proficient by them, until the set is built again and put in force.</source>
        <translation>Vorläufige Grenzwerte der Aufgabe, die Version %1 des Satzes nicht übernimmt: %2. Versuche werden nur vorläufig bestanden, und „sicher beherrscht“ wird mit ihnen nie festgestellt, bis der Satz neu gebildet und in Kraft gesetzt ist.</translation>
    </message>
    <message>
        <source>Limits of the task that this set takes over as limits of the site: %1.</source>
        <translation>Grenzwerte der Aufgabe, die dieser Satz als Grenzwerte des Standorts übernimmt: %1.</translation>
    </message>
    <message>
        <source>Experts and attempts here</source>
        <translation>Experten und Versuche hier</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::LockPage</name>
    <message>
        <source>Locked</source>
        <translation>Gesperrt</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Passwort</translation>
    </message>
    <message>
        <source>Switch user</source>
        <translation>Benutzerwechsel</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Entsperren</translation>
    </message>
    <message>
        <source>%1 is signed in. The content is hidden after ten minutes without input.</source>
        <translation>%1 ist angemeldet. Nach zehn Minuten ohne Eingabe wird der Inhalt verborgen.</translation>
    </message>
    <message>
        <source>Unlocking …</source>
        <translation>Wird entsperrt …</translation>
    </message>
    <message>
        <source>Password of the server&apos;s account</source>
        <translation>Passwort des Serverkontos</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::MainWindow</name>
    <message>
        <source>Fulcrum</source>
        <translation>Fulcrum</translation>
    </message>
    <message>
        <source>Acting role</source>
        <translation>Aktive Rolle</translation>
    </message>
    <message>
        <source>Switch user</source>
        <translation>Benutzerwechsel</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Fulcrum — %1, %2</source>
        <translation>Fulcrum — %1, %2</translation>
    </message>
    <message>
        <source>Demonstration</source>
        <translation>Vorführung</translation>
    </message>
    <message>
        <source>Acting as %1</source>
        <translation>Tätig als %1</translation>
    </message>
    <message>
        <source>Change password</source>
        <translation>Passwort ändern</translation>
    </message>
    <message>
        <source>Programme server, read only: attempts, ratings and decisions are made at the stations.</source>
        <translation>Programmserver, nur lesen: Versuche, Bewertungen und Entscheidungen geschehen an den Stationen.</translation>
    </message>
    <message>
        <source>Demonstration: the people and their attempts are simulated.</source>
        <translation>Vorführung: Die Personen und ihre Versuche sind simuliert.</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Menü</translation>
    </message>
    <message>
        <source>You still act as %1. As %2 you see the pages of that role.</source>
        <translation>Sie sind noch als %1 tätig. Als %2 sehen Sie die Seiten dieser Rolle.</translation>
    </message>
    <message>
        <source>Act as %1</source>
        <translation>Als %1 tätig werden</translation>
    </message>
    <message>
        <source>Stay %1</source>
        <translation>%1 bleiben</translation>
    </message>
    <message>
        <source>a draft of the curriculum by somebody who has signed out</source>
        <translation>ein Entwurf des Curriculums von jemandem, der abgemeldet ist</translation>
    </message>
    <message>
        <source>Go back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Not saved yet, and lost when the pages are made again for this: %1.</source>
        <translation>Noch nicht gespeichert und verloren, wenn die Seiten dafür neu aufgebaut werden: %1.</translation>
    </message>
    <message>
        <source>Change it and lose that</source>
        <translation>Ändern und das verlieren</translation>
    </message>
    <message>
        <source>Not saved yet, and lost at the sign-out: %1.</source>
        <translation>Noch nicht gespeichert und mit dem Abmelden verloren: %1.</translation>
    </message>
    <message>
        <source>Sign out and lose that</source>
        <translation>Abmelden und das verlieren</translation>
    </message>
    <message>
        <source>Not saved yet, and lost when the window closes: %1.</source>
        <translation>Noch nicht gespeichert und verloren, wenn das Fenster schließt: %1.</translation>
    </message>
    <message>
        <source>Close and lose that</source>
        <translation>Schließen und das verlieren</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::MergeCard</name>
    <message>
        <source>Account that stays</source>
        <translation>Konto, das bleibt</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Reason, for the audit log</source>
        <translation>Grund, für das Protokoll</translation>
    </message>
    <message>
        <source>Merge</source>
        <translation>Zusammenführen</translation>
    </message>
    <message>
        <source>Undo the merge</source>
        <translation>Zusammenführen rückgängig machen</translation>
    </message>
    <message>
        <source>nobody chosen</source>
        <translation>niemand gewählt</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>cohort: %1</source>
        <translation>Kohorte: %1</translation>
    </message>
    <message>
        <source>Nothing follows to %1.</source>
        <translation>Nichts geht auf %1 über.</translation>
    </message>
    <message>
        <source>These follow to %1:</source>
        <translation>Das geht auf %1 über:</translation>
    </message>
    <message>
        <source>Merged.</source>
        <translation>Zusammengeführt.</translation>
    </message>
    <message>
        <source>The merge was undone.</source>
        <translation>Das Zusammenführen wurde rückgängig gemacht.</translation>
    </message>
    <message>
        <source>Does this person have two accounts?</source>
        <translation>Hat diese Person zwei Konten?</translation>
    </message>
    <message>
        <source>This account was merged into that of %1. It can no longer be used to sign in.</source>
        <translation>Dieses Konto wurde mit dem von %1 zusammengeführt. Mit ihm kann man sich nicht mehr anmelden.</translation>
    </message>
    <message>
        <source>Merge this account into the other account of the same person. This login can then no longer be used to sign in.</source>
        <translation>Führen Sie dieses Konto mit dem anderen derselben Person zusammen. Mit diesem Anmeldenamen kann man sich danach nicht mehr anmelden.</translation>
    </message>
    <message>
        <source>a reason for merging two accounts</source>
        <translation>ein Grund für das Zusammenführen zweier Konten</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::MetricsPage</name>
    <message>
        <source>lower is better</source>
        <translation>niedriger ist besser</translation>
    </message>
    <message>
        <source>higher is better</source>
        <translation>höher ist besser</translation>
    </message>
    <message>
        <source>← Back to the attempt</source>
        <translation>← Zurück zum Versuch</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Kennzahlen</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search names and explanations</source>
        <translation>In Namen und Erklärungen suchen</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Kennzahl</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Gate in</source>
        <translation>Kriterium in</translation>
    </message>
    <message>
        <source>No metric matches.</source>
        <translation>Keine Kennzahl gefunden.</translation>
    </message>
    <message>
        <source>To improve: %1</source>
        <translation>Verbesserung: %1</translation>
    </message>
    <message>
        <source>Evidence: %1</source>
        <translation>Evidenz: %1</translation>
    </message>
    <message>
        <source>Source: %1</source>
        <translation>Quelle: %1</translation>
    </message>
    <message>
        <source>Name in exports: %1, version %2</source>
        <translation>Name in Exporten: %1, Version %2</translation>
    </message>
    <message>
        <source>for information only</source>
        <translation>nur zur Einordnung</translation>
    </message>
    <message>
        <source>strong (several studies separate experts from novices with it)</source>
        <translation>stark (mehrere Studien unterscheiden damit Experten von Anfängern)</translation>
    </message>
    <message>
        <source>moderate (one study, or several with small groups)</source>
        <translation>mittel (eine Studie oder mehrere mit kleinen Fallzahlen)</translation>
    </message>
    <message>
        <source>expert opinion (no published study separates experts from novices with it)</source>
        <translation>Expertenmeinung (keine veröffentlichte Studie unterscheidet damit Experten von Anfängern)</translation>
    </message>
    <message>
        <source>What the simulator measures. A gate is a pass criterion of a task; to pass, every gate of the task must be met.</source>
        <translation>Was der Simulator misst. Ein Kriterium entscheidet über das Bestehen einer Aufgabe; zum Bestehen muss jedes Kriterium der Aufgabe erfüllt sein.</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::MetricsTable</name>
    <message>
        <source>Explain</source>
        <translation>Erklären</translation>
    </message>
    <message>
        <source>What %1 measures</source>
        <translation>Was %1 misst</translation>
    </message>
    <message>
        <source>Explain %1</source>
        <translation>%1 erklären</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Kennzahl</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Hand</translation>
    </message>
    <message>
        <source>Tissue</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Why absent</source>
        <translation>Fehlt, weil</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Bedeutung</translation>
    </message>
    <message>
        <source>%1, version %2</source>
        <translation>%1, Version %2</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>↓ lower</source>
        <translation>↓ niedriger</translation>
    </message>
    <message>
        <source>↑ higher</source>
        <translation>↑ höher</translation>
    </message>
    <message>
        <source>context</source>
        <translation>Einordnung</translation>
    </message>
    <message>
        <source>Select a row to go to its moment, or Explain to read what is measured.</source>
        <translation>Wählen Sie eine Zeile, um zu ihrem Zeitpunkt zu springen, oder „Erklären“, um zu lesen, was gemessen wird.</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>All metrics</source>
        <translation>Alle Kennzahlen</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::MouseKeyboardInput</name>
    <message>
        <source>Arrows</source>
        <translation>Pfeile</translation>
    </message>
    <message>
        <source>scope: look · in, out</source>
        <translation>Optik: sehen · hinein, heraus</translation>
    </message>
    <message>
        <source>scope: light post · camera head</source>
        <translation>Optik: Lichtanschluss · Kamerakopf</translation>
    </message>
    <message>
        <source>Right button</source>
        <translation>Rechte Taste</translation>
    </message>
    <message>
        <source>Left button</source>
        <translation>Linke Taste</translation>
    </message>
    <message>
        <source>Escape, F1	pause · this help</source>
        <translation>Escape, F1	Pause · diese Hilfe</translation>
    </message>
    <message>
        <source>Direction pad	scope: look</source>
        <translation>Steuerkreuz	Optik: sehen</translation>
    </message>
    <message>
        <source>Upper button + pad	scope: in, out · light post</source>
        <translation>Obere Taste + Kreuz	Optik: hinein, heraus · Lichtanschluss</translation>
    </message>
    <message>
        <source>Back button + pad	camera head</source>
        <translation>Zurück-Taste + Kreuz	Kamerakopf</translation>
    </message>
    <message>
        <source>Start button	pause and resume (Escape; F1: this help)</source>
        <translation>Start-Taste	Pause und weiter (Escape; F1: diese Hilfe)</translation>
    </message>
    <message>
        <source>Left stick	moves the handle of the scope; the lens goes the other way</source>
        <translation>Linker Stick	bewegt den Griff der Optik; die Linse geht in die Gegenrichtung</translation>
    </message>
    <message>
        <source>Left shoulder button + left stick	in and out · light post</source>
        <translation>Linke Schultertaste + linker Stick	hinein und heraus · Lichtanschluss</translation>
    </message>
    <message>
        <source>Right stick	light post; with its shoulder button: camera head</source>
        <translation>Rechter Stick	Lichtanschluss; mit seiner Schultertaste: Kamerakopf</translation>
    </message>
    <message>
        <source>Each stick	moves the handle of its hand; the tip goes the other way</source>
        <translation>Jeder Stick	bewegt den Griff seiner Hand; die Spitze geht in die Gegenrichtung</translation>
    </message>
    <message>
        <source>Shoulder button + stick	in and out (up, down) · turn (left, right)</source>
        <translation>Schultertaste + Stick	hinein, heraus (oben, unten) · drehen (links, rechts)</translation>
    </message>
    <message>
        <source>Trigger	closes the jaws of that hand, then presses</source>
        <translation>Trigger	schließt das Maul dieser Hand, dann drückt er</translation>
    </message>
    <message>
        <source>Press on a stick	jaws stay closed, or open again</source>
        <translation>Druck auf einen Stick	Maul bleibt zu oder öffnet wieder</translation>
    </message>
    <message>
        <source>Left, right button	pedal of that hand (energy, suction)</source>
        <translation>Linke, rechte Taste	Pedal dieser Hand (Energie, Sauger)</translation>
    </message>
    <message>
        <source>Lower button	next instrument of the hand that worked last</source>
        <translation>Untere Taste	nächstes Instrument der Hand, die zuletzt arbeitete</translation>
    </message>
    <message>
        <source>Each mouse	moves the handle of its hand; the tip goes the other way</source>
        <translation>Jede Maus	bewegt den Griff ihrer Hand; die Spitze geht in die Gegenrichtung</translation>
    </message>
    <message>
        <source>Left button	closes the jaws of that hand while held</source>
        <translation>Linke Taste	schließt das Maul dieser Hand, solange sie gedrückt ist</translation>
    </message>
    <message>
        <source>Wheel	in and out</source>
        <translation>Rad	hinein und heraus</translation>
    </message>
    <message>
        <source>Middle button	pedal of that hand (energy, suction)</source>
        <translation>Mittlere Taste	Pedal dieser Hand (Energie, Sauger)</translation>
    </message>
    <message>
        <source>Side button	next instrument of that hand</source>
        <translation>Seitentaste	nächstes Instrument dieser Hand</translation>
    </message>
    <message>
        <source>the mice change hands</source>
        <translation>die Mäuse tauschen die Hände</translation>
    </message>
    <message>
        <source>jaws of the left, right hand stay closed, or open again</source>
        <translation>Maul der linken, rechten Hand bleibt zu oder öffnet wieder</translation>
    </message>
    <message>
        <source>Mouse	moves the handle of the scope; the lens goes the other way</source>
        <translation>Maus	bewegt den Griff der Optik; die Linse geht in die Gegenrichtung</translation>
    </message>
    <message>
        <source>Shift + mouse	turns the light post: the direction in which the scope looks</source>
        <translation>Umschalt + Maus	dreht den Lichtanschluss: die Blickrichtung der Optik</translation>
    </message>
    <message>
        <source>Ctrl + mouse	turns the camera head: the image alone</source>
        <translation>Strg + Maus	dreht den Kamerakopf: nur das Bild</translation>
    </message>
    <message>
        <source>%1: handle · in, out · turn · jaws</source>
        <translation>%1: Griff · hinein, heraus · drehen · Maul</translation>
    </message>
    <message>
        <source>Mouse	moves the handle of the active hand; the tip goes the other way</source>
        <translation>Maus	bewegt den Griff der aktiven Hand; die Spitze geht in die Gegenrichtung</translation>
    </message>
    <message>
        <source>closes the jaws while held</source>
        <translation>schließt das Maul, solange sie gedrückt ist</translation>
    </message>
    <message>
        <source>the other hand</source>
        <translation>die andere Hand</translation>
    </message>
    <message>
        <source>Shift + mouse	turns the shaft</source>
        <translation>Umschalt + Maus	dreht den Schaft</translation>
    </message>
    <message>
        <source>jaws of the active hand stay closed, or open again</source>
        <translation>Maul der aktiven Hand bleibt zu oder öffnet wieder</translation>
    </message>
    <message>
        <source>left hand</source>
        <translation>linke Hand</translation>
    </message>
    <message>
        <source>right hand</source>
        <translation>rechte Hand</translation>
    </message>
    <message>
        <source>pedal of the active hand (energy, suction) · its next instrument</source>
        <translation>Pedal der aktiven Hand (Energie, Sauger) · ihr nächstes Instrument</translation>
    </message>
    <message>
        <source>Right button + mouse	in and out by little (up, down) · turns the shaft (left, right)</source>
        <translation>Rechte Taste + Maus	in kleinen Schritten hinein und heraus (oben, unten) · dreht den Schaft (links, rechts)</translation>
    </message>
    <message>
        <source>sound off, on</source>
        <translation>Ton aus, an</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::OverviewView</name>
    <message>
        <source>%1 of %2 (%3 %, %4 to %5 %)</source>
        <translation>%1 von %2 (%3 %, %4 bis %5 %)</translation>
    </message>
    <message>
        <source>%1 days (%2 to %3)</source>
        <translation>%1 Tage (%2 bis %3)</translation>
    </message>
    <message>
        <source>%1 days (%2 or more)</source>
        <translation>%1 Tage (%2 oder mehr)</translation>
    </message>
    <message>
        <source>People in each standing, task by task</source>
        <translation>Personen je Stand, Aufgabe für Aufgabe</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>First pass after</source>
        <translation>Erstes Bestehen nach</translation>
    </message>
    <message>
        <source>Proficient after</source>
        <translation>Sicher beherrscht nach</translation>
    </message>
    <message>
        <source>fewer than half so far</source>
        <translation>bisher weniger als die Hälfte</translation>
    </message>
    <message>
        <source>Passed: people who passed at least once, of those who tried (95 % interval). Days: from a person&apos;s first attempt that counts; median over people by the Kaplan-Meier method (95 % interval). With provisional limits a task can be passed, but nobody becomes proficient.</source>
        <translation>Bestanden: Personen, die mindestens einmal bestanden haben, von denen, die es versucht haben (95-%-Intervall). Tage: ab dem ersten Versuch einer Person, der zählt; Median über die Personen nach Kaplan und Meier (95-%-Intervall). Mit vorläufigen Grenzwerten ist „bestanden“ möglich, nie „sicher beherrscht“.</translation>
    </message>
    <message>
        <source>people</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>People in each standing</source>
        <translation>Personen in jedem Stand</translation>
    </message>
    <message>
        <source>Tasks of the curriculum</source>
        <translation>Aufgaben des Curriculums</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::PartCard</name>
    <message>
        <source>Metrics of a part</source>
        <translation>Kennzahlen eines Abschnitts</translation>
    </message>
    <message>
        <source>Choose a step, hold Shift and drag in a chart, or set the replay to a moment and start or end the part there.</source>
        <translation>Wählen Sie einen Schritt, ziehen Sie mit gedrückter Umschalttaste in einem Diagramm, oder stellen Sie die Wiedergabe auf einen Zeitpunkt und beginnen oder beenden Sie den Abschnitt dort.</translation>
    </message>
    <message>
        <source>Zoom to the part</source>
        <translation>Abschnitt vergrößern</translation>
    </message>
    <message>
        <source>; no metrics of a part, because this program does not have the task</source>
        <translation>; keine Kennzahlen eines Abschnitts, weil dieses Programm die Aufgabe nicht hat</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::PartChoice</name>
    <message>
        <source>Part</source>
        <translation>Abschnitt</translation>
    </message>
    <message>
        <source>Part of the attempt</source>
        <translation>Abschnitt des Versuchs</translation>
    </message>
    <message>
        <source>Start part here</source>
        <translation>Abschnitt hier beginnen</translation>
    </message>
    <message>
        <source>End part here</source>
        <translation>Abschnitt hier beenden</translation>
    </message>
    <message>
        <source>Whole attempt</source>
        <translation>Ganzer Versuch</translation>
    </message>
    <message>
        <source>Step %1: %2</source>
        <translation>Schritt %1: %2</translation>
    </message>
    <message>
        <source>Own range</source>
        <translation>Eigener Bereich</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::PassRuleChart</name>
    <message>
        <source>attempts</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>passes %1 %</source>
        <translation>besteht %1 %</translation>
    </message>
    <message>
        <source>Chance of being declared proficient, by number of attempts</source>
        <translation>Wahrscheinlichkeit, dass „sicher beherrscht“ festgestellt wird, nach Anzahl der Versuche</translation>
    </message>
    <message>
        <source>passes %1 %, rule in force</source>
        <translation>besteht %1 %, geltende Regel</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::PassRuleDesigner</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message numerus="yes">
        <source>%n passes in a row</source>
        <translation>
            <numerusform>%n bestandener in Folge</numerusform>
            <numerusform>%n bestandene in Folge</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 passes among the last %2 attempts</source>
        <translation>%1 bestandene unter den letzten %2 Versuchen</translation>
    </message>
    <message>
        <source>LC-CUSUM %1/%2 %, limit %3</source>
        <translation>LC-CUSUM %1/%2 %, Grenze %3</translation>
    </message>
    <message>
        <source>Kind of rule</source>
        <translation>Art der Regel</translation>
    </message>
    <message>
        <source>Passes in a row</source>
        <translation>Bestandene in Folge</translation>
    </message>
    <message>
        <source>Passes among the last attempts</source>
        <translation>Bestandene von den letzten</translation>
    </message>
    <message>
        <source>LC-CUSUM</source>
        <translation>LC-CUSUM</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Bestandene</translation>
    </message>
    <message>
        <source>Among the last</source>
        <translation>Unter den letzten</translation>
    </message>
    <message>
        <source>Acceptable failures</source>
        <translation>Annehmbare Misserfolge</translation>
    </message>
    <message>
        <source>Unacceptable failures</source>
        <translation>Nicht annehmbare</translation>
    </message>
    <message>
        <source>Limit of the sum</source>
        <translation>Grenze der Summe</translation>
    </message>
    <message>
        <source>Chance of being declared proficient</source>
        <translation>Wahrscheinlichkeit, dass „sicher beherrscht“ festgestellt wird</translation>
    </message>
    <message>
        <source>%1 attempts</source>
        <translation>%1 Versuche</translation>
    </message>
    <message>
        <source>Dashed, and in brackets: the rule in force, %1.</source>
        <translation>Gestrichelt und in Klammern: die geltende Regel, %1.</translation>
    </message>
    <message>
        <source>This is the rule in force.</source>
        <translation>Das ist die geltende Regel.</translation>
    </message>
    <message>
        <source>Half are proficient after</source>
        <translation>Hälfte beherrscht sie nach</translation>
    </message>
    <message>
        <source>LC-CUSUM is a running sum: a pass raises it, a failure lowers it by more, never below 0. A trainee whose sum reaches the limit is proficient.</source>
        <translation>LC-CUSUM ist eine laufende Summe: Ein bestandener Versuch hebt sie, ein nicht bestandener senkt sie stärker, nie unter 0. Wer die Grenze erreicht, beherrscht die Aufgabe sicher.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::PasswordPage</name>
    <message>
        <source>a new password</source>
        <translation>ein neues Passwort</translation>
    </message>
    <message>
        <source>Choose a new password</source>
        <translation>Neues Passwort wählen</translation>
    </message>
    <message>
        <source>Current password</source>
        <translation>Aktuelles Passwort</translation>
    </message>
    <message>
        <source>New password</source>
        <translation>Neues Passwort</translation>
    </message>
    <message>
        <source>at least %1 characters</source>
        <translation>mindestens %1 Zeichen</translation>
    </message>
    <message>
        <source>New password again</source>
        <translation>Neues Passwort wiederholen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Change password</source>
        <translation>Passwort ändern</translation>
    </message>
    <message>
        <source>You signed in with a one-time password. It was made for you by somebody else, so choose one that only you know.</source>
        <translation>Sie haben sich mit einem Einmalpasswort angemeldet. Jemand anderes hat es für Sie erstellt. Wählen Sie deshalb eines, das nur Sie kennen.</translation>
    </message>
    <message>
        <source>It takes effect at your next sign-in.</source>
        <translation>Es gilt ab Ihrer nächsten Anmeldung.</translation>
    </message>
    <message>
        <source>Sign out</source>
        <translation>Abmelden</translation>
    </message>
    <message>
        <source>The two new passwords are not the same.</source>
        <translation>Die beiden neuen Passwörter stimmen nicht überein.</translation>
    </message>
    <message>
        <source>The password needs at least %1 characters.</source>
        <translation>Das Passwort braucht mindestens %1 Zeichen.</translation>
    </message>
    <message>
        <source>Password changed.</source>
        <translation>Passwort geändert.</translation>
    </message>
    <message>
        <source>Changing the password …</source>
        <translation>Passwort wird geändert …</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::PathView</name>
    <message>
        <source>Paths of both instrument tips</source>
        <translation>Wege beider Instrumentenspitzen</translation>
    </message>
    <message>
        <source>No path was recorded</source>
        <translation>Kein Weg aufgezeichnet</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>head</source>
        <translation>kranial</translation>
    </message>
    <message>
        <source>front</source>
        <translation>ventral</translation>
    </message>
    <message>
        <source>— left hand</source>
        <translation>— linke Hand</translation>
    </message>
    <message>
        <source>- - right hand</source>
        <translation>- - rechte Hand</translation>
    </message>
    <message>
        <source>%1 s: %2</source>
        <translation>%1 s: %2</translation>
    </message>
    <message>
        <source>Drag or use the arrow keys to turn it; scroll, or + and −, to zoom.</source>
        <translation>Ziehen oder Pfeiltasten drehen es; Mausrad oder + und − zoomen.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::PathologyCard</name>
    <message>
        <source>Pathology report (simulated)</source>
        <translation>Pathologiebericht (simuliert)</translation>
    </message>
    <message>
        <source>Show the deepest defect</source>
        <translation>Tiefsten Defekt zeigen</translation>
    </message>
    <message>
        <source>All numbers</source>
        <translation>Alle Zahlen</translation>
    </message>
    <message>
        <source>Hide the numbers</source>
        <translation>Zahlen ausblenden</translation>
    </message>
    <message>
        <source>Select a sector to see its numbers.</source>
        <translation>Wählen Sie einen Sektor, um seine Zahlen zu sehen.</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Show: %1</source>
        <translation>Zeigen: %1</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>In 3D</source>
        <translation>In 3D</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::PeoplePage</name>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>One-time password</source>
        <translation>Einmalpasswort</translation>
    </message>
    <message>
        <source>I have handed it over</source>
        <translation>Ich habe es übergeben</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Login</source>
        <translation>Anmeldename</translation>
    </message>
    <message>
        <source>Roles</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>Account</source>
        <translation>Konto</translation>
    </message>
    <message>
        <source>Last sign-in</source>
        <translation>Letzte Anmeldung</translation>
    </message>
    <message>
        <source>Add a person</source>
        <translation>Person hinzufügen</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Issue one-time password</source>
        <translation>Einmalpasswort ausgeben</translation>
    </message>
    <message>
        <source>active</source>
        <translation>aktiv</translation>
    </message>
    <message>
        <source>deactivated</source>
        <translation>deaktiviert</translation>
    </message>
    <message>
        <source> · synthetic</source>
        <translation> · synthetisch</translation>
    </message>
    <message>
        <source>Deactivate</source>
        <translation>Deaktivieren</translation>
    </message>
    <message>
        <source>Activate</source>
        <translation>Aktivieren</translation>
    </message>
    <message>
        <source>%1: %2
Valid for 24 hours and shown only now. It must be changed at the first sign-in.</source>
        <translation>%1: %2
Gilt 24 Stunden und wird nur jetzt angezeigt. Es muss bei der ersten Anmeldung geändert werden.</translation>
    </message>
    <message>
        <source>Saved.</source>
        <translation>Gespeichert.</translation>
    </message>
    <message>
        <source>merged</source>
        <translation>zusammengeführt</translation>
    </message>
    <message>
        <source>On the sign-in screen, list the people who signed in here in the last 30 days</source>
        <translation>Auf der Anmeldeseite die Personen zeigen, die sich hier in den letzten 30 Tagen angemeldet haben</translation>
    </message>
    <message>
        <source>Letters, digits and . _ - @</source>
        <translation>Buchstaben, Ziffern und . _ - @</translation>
    </message>
    <message>
        <source>Add person</source>
        <translation>Person hinzufügen</translation>
    </message>
    <message>
        <source>a person who is not added yet</source>
        <translation>eine Person, die noch nicht angelegt ist</translation>
    </message>
    <message>
        <source>changes to a person</source>
        <translation>Änderungen an einer Person</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::PersonalDataPage</name>
    <message>
        <source>Personal data</source>
        <translation>Personendaten</translation>
    </message>
    <message>
        <source>One person</source>
        <translation>Eine Person</translation>
    </message>
    <message>
        <source>All that this store holds about a person: look at it, write it to a folder for the person, or erase it. The audit log says that it was done.</source>
        <translation>Alles, was dieser Datenbestand über eine Person enthält: ansehen, für die Person in einen Ordner schreiben oder löschen. Das Protokoll vermerkt es.</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>Stored</source>
        <translation>Gespeichert</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Write to a folder …</source>
        <translation>In einen Ordner schreiben …</translation>
    </message>
    <message>
        <source>New folder for the data</source>
        <translation>Neuer Ordner für die Daten</translation>
    </message>
    <message>
        <source>Reason for erasing; it stays, so name nobody in it</source>
        <translation>Grund für das Löschen; er bleibt erhalten, nennen Sie darin niemanden</translation>
    </message>
    <message>
        <source>Reason for erasing</source>
        <translation>Grund für das Löschen</translation>
    </message>
    <message>
        <source>Erase this person</source>
        <translation>Diese Person löschen</translation>
    </message>
    <message>
        <source>Erase for good</source>
        <translation>Endgültig löschen</translation>
    </message>
    <message>
        <source>How long data are kept</source>
        <translation>Wie lange Daten aufbewahrt werden</translation>
    </message>
    <message>
        <source>Trainees whose last practice or sign-in is longer ago are listed here. Nobody is erased until you do it.</source>
        <translation>Lernende, deren letzte Übung oder Anmeldung länger zurückliegt, werden hier aufgeführt. Niemand wird gelöscht, bis Sie es tun.</translation>
    </message>
    <message>
        <source>Keep data of trainees for</source>
        <translation>Daten von Lernenden aufbewahren:</translation>
    </message>
    <message>
        <source>Months after the last practice</source>
        <translation>Monate nach der letzten Übung</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>months after the last practice</source>
        <translation>Monate nach der letzten Übung</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Login</source>
        <translation>Anmeldename</translation>
    </message>
    <message>
        <source>Last practice</source>
        <translation>Letzte Übung</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Erase all listed</source>
        <translation>Alle aufgeführten löschen</translation>
    </message>
    <message numerus="yes">
        <source>Erase %n people for good</source>
        <translation>
            <numerusform>%n Person endgültig löschen</numerusform>
            <numerusform>%n Personen endgültig löschen</numerusform>
        </translation>
    </message>
    <message>
        <source>nobody chosen</source>
        <translation>niemand gewählt</translation>
    </message>
    <message>
        <source>Reading what is stored …</source>
        <translation>Gespeichertes wird gelesen …</translation>
    </message>
    <message>
        <source>Recordings in this store: %1</source>
        <translation>Aufzeichnungen in diesem Datenbestand: %1</translation>
    </message>
    <message>
        <source>Written to %1. Give it to the person, and delete it.</source>
        <translation>Geschrieben nach %1. Geben Sie es der Person, und löschen Sie es.</translation>
    </message>
    <message>
        <source>Writing the data …</source>
        <translation>Die Daten werden geschrieben …</translation>
    </message>
    <message>
        <source>Erased. A backup from before still has the person; restoring it erases them again.</source>
        <translation>Gelöscht. Eine ältere Sicherung enthält die Person noch; beim Wiederherstellen wird sie wieder gelöscht.</translation>
    </message>
    <message>
        <source>Looking for people who are due …</source>
        <translation>Es wird gesucht, wer zu löschen ist …</translation>
    </message>
    <message>
        <source>No end is set: nobody is due.</source>
        <translation>Es ist kein Ende festgelegt: Niemand ist zu löschen.</translation>
    </message>
    <message>
        <source>Nobody is due.</source>
        <translation>Niemand ist zu löschen.</translation>
    </message>
    <message numerus="yes">
        <source>%n people are due.</source>
        <translation>
            <numerusform>%n Person ist zu löschen.</numerusform>
            <numerusform>%n Personen sind zu löschen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Saved.</source>
        <translation>Gespeichert.</translation>
    </message>
    <message numerus="yes">
        <source>%n people were erased.</source>
        <translation>
            <numerusform>%n Person wurde gelöscht.</numerusform>
            <numerusform>%n Personen wurden gelöscht.</numerusform>
        </translation>
    </message>
    <message>
        <source>Erasing …</source>
        <translation>Es wird gelöscht …</translation>
    </message>
    <message>
        <source>The demonstration holds simulated people only.</source>
        <translation>Die Vorführung enthält nur simulierte Personen.</translation>
    </message>
    <message>
        <source>a reason for erasing somebody</source>
        <translation>ein Grund für das Löschen einer Person</translation>
    </message>
    <message>
        <source>how long data are kept</source>
        <translation>wie lange Daten aufbewahrt werden</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::PictureCard</name>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>The scene cannot be drawn on this machine: %1</source>
        <translation>Die Szene kann auf diesem Rechner nicht gezeichnet werden: %1</translation>
    </message>
    <message>
        <source>Drawn by: %1</source>
        <translation>Gezeichnet von: %1</translation>
    </message>
    <message>
        <source>The processor draws the picture, because OpenGL offers no graphics card here.</source>
        <translation>Der Prozessor zeichnet das Bild, weil OpenGL hier keine Grafikkarte anbietet.</translation>
    </message>
    <message>
        <source>Anti-aliasing: 4 samples per pixel.</source>
        <translation>Kantenglättung: 4 Abtastpunkte je Bildpunkt.</translation>
    </message>
    <message>
        <source>Anti-aliasing: edges of instruments and targets, after drawing. Several samples per pixel would take too long on a processor.</source>
        <translation>Kantenglättung: Kanten von Instrumenten und Zielen, nach dem Zeichnen. Mehrere Abtastpunkte je Bildpunkt würden auf einem Prozessor zu lange dauern.</translation>
    </message>
    <message>
        <source>Resolution: %1 % of the window&apos;s, %2 % inside the pelvis, so that drawing takes less than %3 ms. If it takes longer, the resolution is reduced, to %4 % of that at the least, and raised again when there is time.</source>
        <translation>Auflösung: %1 % der Auflösung des Fensters, im Becken %2 %, damit ein Bild weniger als %3 ms braucht. Braucht es länger, wird sie gesenkt, höchstens auf %4 % davon, und wieder angehoben, wenn Zeit ist.</translation>
    </message>
    <message>
        <source>Resolution: that of the window. If drawing takes longer than %1 ms, it is reduced, to %2 % at the least, and raised again when there is time.</source>
        <translation>Auflösung: die des Fensters. Braucht ein Bild länger als %1 ms, wird sie gesenkt, höchstens auf %2 %, und wieder angehoben, wenn Zeit ist.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::PracticeView</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message numerus="yes">
        <source>%1, week of %2: %n attempts</source>
        <translation>
            <numerusform>%1, Woche vom %2: %n Versuch</numerusform>
            <numerusform>%1, Woche vom %2: %n Versuche</numerusform>
        </translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>no attempt</source>
        <translation>kein Versuch</translation>
    </message>
    <message>
        <source>Days of practice</source>
        <translation>Übungstage</translation>
    </message>
    <message>
        <source>1 attempt</source>
        <translation>1 Versuch</translation>
    </message>
    <message>
        <source>2 or 3 attempts</source>
        <translation>2 oder 3 Versuche</translation>
    </message>
    <message>
        <source>4 attempts or more</source>
        <translation>4 oder mehr Versuche</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::ProgressPage</name>
    <message>
        <source>Reading the attempts …</source>
        <translation>Die Versuche werden gelesen …</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Kennzahl</translation>
    </message>
    <message>
        <source>Explain</source>
        <translation>Erklären</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Started</source>
        <translation>Beginn</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>My progress</source>
        <translation>Mein Fortschritt</translation>
    </message>
    <message>
        <source>Progress of %1</source>
        <translation>Fortschritt von %1</translation>
    </message>
    <message>
        <source>attempt %1, %2: %3, %4</source>
        <translation>Versuch %1, %2: %3, %4</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>experts (mean ± one standard deviation)</source>
        <translation>Experten (Mittelwert ± eine Standardabweichung)</translation>
    </message>
    <message>
        <source>● passed   ✕ failed   ○ not scored   Small: does not count. Each type of device has its own line. Thick line: fitted learning curve. Band: the level it approaches (95 % interval). Select a point to open the attempt: click it, or choose it with the arrow keys and press Enter.</source>
        <translation>● bestanden   ✕ nicht bestanden   ○ nicht ausgewertet   Klein: zählt nicht. Jede Art von Gerät hat ihre eigene Linie. Dicke Linie: angepasste Lernkurve. Band: der Wert, dem sie sich nähert (95-%-Intervall). Wählen Sie einen Punkt, um den Versuch zu öffnen: mit einem Klick oder mit den Pfeiltasten und der Eingabetaste.</translation>
    </message>
    <message>
        <source>%1 · %3 of %2 counting attempts passed</source>
        <translation>%1 · %3 von %2 zählenden Versuchen bestanden</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>%1, version %2</source>
        <translation>%1, Version %2</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::RatingEditor</name>
    <message>
        <source>Notes on this rating</source>
        <translation>Notizen zu dieser Beurteilung</translation>
    </message>
    <message>
        <source>Notes: what you saw, and one thing to try</source>
        <translation>Notizen: was Sie gesehen haben, und ein Vorschlag</translation>
    </message>
    <message>
        <source>Hand in the rating</source>
        <translation>Beurteilung abgeben</translation>
    </message>
    <message>
        <source>Discard the draft</source>
        <translation>Entwurf verwerfen</translation>
    </message>
    <message>
        <source>Discard it for good</source>
        <translation>Endgültig verwerfen</translation>
    </message>
    <message>
        <source>Total: %1</source>
        <translation>Summe: %1</translation>
    </message>
    <message>
        <source>Total so far: %1 · items left: %2</source>
        <translation>Summe bisher: %1 · offene Punkte: %2</translation>
    </message>
    <message>
        <source>Not rated yet: %1.</source>
        <translation>Noch nicht beurteilt: %1.</translation>
    </message>
    <message>
        <source>The draft is saved. After you hand in a rating, it cannot be changed.</source>
        <translation>Der Entwurf ist gespeichert. Nach der Abgabe kann eine Beurteilung nicht mehr geändert werden.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::RatingsCard</name>
    <message>
        <source>Show the ratings to the trainee</source>
        <translation>Beurteilungen für Lernende freigeben</translation>
    </message>
    <message>
        <source>The rating is handed in.</source>
        <translation>Die Beurteilung ist abgegeben.</translation>
    </message>
    <message>
        <source>Observer form</source>
        <translation>Beurteilungsbogen</translation>
    </message>
    <message>
        <source>Rate with this form</source>
        <translation>Mit diesem Bogen beurteilen</translation>
    </message>
    <message>
        <source>Ratings</source>
        <translation>Beurteilungen</translation>
    </message>
    <message>
        <source>Ratings (%1)</source>
        <translation>Beurteilungen (%1)</translation>
    </message>
    <message>
        <source>Ratings that are not shown to you: %1.</source>
        <translation>Beurteilungen, die Ihnen nicht gezeigt werden: %1.</translation>
    </message>
    <message>
        <source>Show those that the trainee sees, without rating (%1)</source>
        <translation>Freigegebene Beurteilungen zeigen, ohne selbst zu beurteilen (%1)</translation>
    </message>
    <message>
        <source>shown to the trainee</source>
        <translation>freigegeben</translation>
    </message>
    <message>
        <source>not shown to the trainee</source>
        <translation>nicht freigegeben</translation>
    </message>
    <message>
        <source>Ratings that the trainee sees from now on: %1.</source>
        <translation>Neu freigegebene Beurteilungen: %1.</translation>
    </message>
    <message>
        <source>Ratings by others: %1. You will see them when you have handed in yours.</source>
        <translation>Beurteilungen anderer: %1. Sie sehen sie, sobald Sie Ihre abgegeben haben.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::RealignmentTexts</name>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>✓ %1: in place</source>
        <translation>✓ %1: in Position</translation>
    </message>
    <message>
        <source>→ %1: %2 mm and %3° away from its ghost</source>
        <translation>→ %1: %2 mm und %3° vom Schattenbild entfernt</translation>
    </message>
    <message>
        <source>In place. Press Enter to continue as practice.</source>
        <translation>In Position. Drücken Sie die Eingabetaste, um als Übung fortzufahren.</translation>
    </message>
    <message>
        <source>The device is back. Bring each instrument onto its ghost.</source>
        <translation>Das Gerät ist wieder da. Bringen Sie jedes Instrument auf sein Schattenbild.</translation>
    </message>
    <message>
        <source>The timer is stopped. Esc: abandon the attempt.</source>
        <translation>Die Uhr ist angehalten. Esc: Versuch abbrechen.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::RemediesForm</name>
    <message>
        <source>%1 (not installed)</source>
        <translation>%1 (nicht installiert)</translation>
    </message>
    <message>
        <source>Recommended to a trainee whose curve levels off below the pass mark: the remedy whose metric is furthest beyond its bound, in the median of the latest five attempts.</source>
        <translation>Empfohlen, wenn die Lernkurve unter der Bestehensgrenze ein Plateau erreicht: die Abhilfe, deren Kennzahl im Median der letzten fünf Versuche am weitesten jenseits ihrer Grenze liegt.</translation>
    </message>
    <message>
        <source>Remedies</source>
        <translation>Abhilfen</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Kennzahl</translation>
    </message>
    <message>
        <source>above the bound</source>
        <translation>über der Grenze</translation>
    </message>
    <message>
        <source>below the bound</source>
        <translation>unter der Grenze</translation>
    </message>
    <message>
        <source>When it is</source>
        <translation>Wenn sie liegt</translation>
    </message>
    <message>
        <source>Bound</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>practise a part</source>
        <translation>einen Teil üben</translation>
    </message>
    <message>
        <source>another task</source>
        <translation>andere Aufgabe</translation>
    </message>
    <message>
        <source>another variant</source>
        <translation>andere Variante</translation>
    </message>
    <message>
        <source>practise with a ghost</source>
        <translation>mit einem Schattenbild üben</translation>
    </message>
    <message>
        <source>watch an expert</source>
        <translation>einem Experten zusehen</translation>
    </message>
    <message>
        <source>look at the replay</source>
        <translation>die Wiedergabe ansehen</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Was zu tun ist</translation>
    </message>
    <message>
        <source>Goal or task</source>
        <translation>Ziel oder Aufgabe</translation>
    </message>
    <message>
        <source>Variant</source>
        <translation>Variante</translation>
    </message>
    <message>
        <source>Add a remedy</source>
        <translation>Abhilfe hinzufügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>▲ Up</source>
        <translation>▲ Auf</translation>
    </message>
    <message>
        <source>▼ Down</source>
        <translation>▼ Ab</translation>
    </message>
    <message>
        <source>any</source>
        <translation>beliebig</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::RepairPage</name>
    <message>
        <source>Restore a backup</source>
        <translation>Sicherung wiederherstellen</translation>
    </message>
    <message>
        <source>The backup is read from end to end before it takes the store&apos;s place. What is there now is kept under another name. What was done after the backup is not in it.</source>
        <translation>Die Sicherung wird ganz gelesen, bevor sie an die Stelle des Datenbestands tritt. Was jetzt dort ist, bleibt unter einem anderen Namen erhalten. Was nach der Sicherung getan wurde, ist nicht in ihr.</translation>
    </message>
    <message>
        <source>Last entry</source>
        <translation>Letzter Eintrag</translation>
    </message>
    <message>
        <source>Programme</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Holds</source>
        <translation>Enthält</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Look in another folder …</source>
        <translation>In einem anderen Ordner suchen …</translation>
    </message>
    <message>
        <source>Folder with backups</source>
        <translation>Ordner mit Sicherungen</translation>
    </message>
    <message>
        <source>Administrator of the backup</source>
        <translation>Administrator der Sicherung</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Passwort</translation>
    </message>
    <message>
        <source>Restore this backup</source>
        <translation>Diese Sicherung wiederherstellen</translation>
    </message>
    <message>
        <source>Other ways</source>
        <translation>Andere Wege</translation>
    </message>
    <message>
        <source>Keep the file under another name</source>
        <translation>Datei unter anderem Namen behalten</translation>
    </message>
    <message>
        <source>Open another programme …</source>
        <translation>Anderes Programm öffnen …</translation>
    </message>
    <message>
        <source>Store of another programme</source>
        <translation>Datenbestand eines anderen Programms</translation>
    </message>
    <message>
        <source>Store (*.db)</source>
        <translation>Datenbestand (*.db)</translation>
    </message>
    <message>
        <source>Look around</source>
        <translation>Umsehen</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>The file stays in its folder, with &quot;.damaged&quot; and the time behind its name. Fulcrum then begins with an empty store; a backup can be restored later.</source>
        <translation>Die Datei bleibt in ihrem Ordner, mit „.damaged“ und der Zeit hinter ihrem Namen. Fulcrum beginnt dann mit einem leeren Datenbestand; eine Sicherung lässt sich später wiederherstellen.</translation>
    </message>
    <message>
        <source>Give it another name</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>The store is damaged</source>
        <translation>Der Datenbestand ist beschädigt</translation>
    </message>
    <message>
        <source>The store cannot be opened</source>
        <translation>Der Datenbestand lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Noch einmal versuchen</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>The store: %1</source>
        <translation>Der Datenbestand: %1</translation>
    </message>
    <message>
        <source>Looking for backups …</source>
        <translation>Sicherungen werden gesucht …</translation>
    </message>
    <message>
        <source>No backup was found in %1.</source>
        <translation>In %1 wurde keine Sicherung gefunden.</translation>
    </message>
    <message>
        <source>Found in %1.</source>
        <translation>Gefunden in %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n people</source>
        <translation>
            <numerusform>%n Person</numerusform>
            <numerusform>%n Personen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempts</source>
        <translation>
            <numerusform>%n Versuch</numerusform>
            <numerusform>%n Versuche</numerusform>
        </translation>
    </message>
    <message>
        <source>✓ no damage found</source>
        <translation>✓ kein Schaden gefunden</translation>
    </message>
    <message>
        <source>✕ cannot be used</source>
        <translation>✕ nicht verwendbar</translation>
    </message>
    <message>
        <source>The backup was restored.</source>
        <translation>Die Sicherung wurde wiederhergestellt.</translation>
    </message>
    <message>
        <source>The backup was restored. What was there before is kept in %1</source>
        <translation>Die Sicherung wurde wiederhergestellt. Was vorher dort war, ist erhalten in %1</translation>
    </message>
    <message>
        <source>Restoring the backup …</source>
        <translation>Die Sicherung wird wiederhergestellt …</translation>
    </message>
    <message>
        <source>The file is kept in %1</source>
        <translation>Die Datei ist erhalten in %1</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::ReplayPanel</name>
    <message>
        <source>Moment of the attempt</source>
        <translation>Zeitpunkt des Versuchs</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>◀ Step</source>
        <translation>◀ Bild</translation>
    </message>
    <message>
        <source>Step ▶</source>
        <translation>Bild ▶</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Practise from here</source>
        <translation>Ab hier üben</translation>
    </message>
    <message>
        <source>A practice run that begins with the scene as it is at this moment. It is never scored.</source>
        <translation>Eine Übung, die mit der Szene beginnt, wie sie zu diesem Zeitpunkt ist. Sie wird nie ausgewertet.</translation>
    </message>
    <message>
        <source>reading the recording …</source>
        <translation>Aufzeichnung wird gelesen …</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Practice cannot begin at this moment yet: wait until it is prepared, or choose a later one.</source>
        <translation>Zu diesem Zeitpunkt kann die Übung noch nicht beginnen: Warten Sie, bis er vorbereitet ist, oder wählen Sie einen späteren.</translation>
    </message>
    <message>
        <source>tissue differs from the record from %1 s on (another build); poses and forces are the recorded ones</source>
        <translation>Gewebe weicht ab %1 s von der Aufzeichnung ab (andere Softwareversion); Stellungen und Kräfte sind die aufgezeichneten</translation>
    </message>
    <message>
        <source>preparing %1&#xa0;%</source>
        <translation>Vorbereitung %1&#xa0;%</translation>
    </message>
    <message>
        <source>replay ×%1</source>
        <translation>Wiedergabe ×%1</translation>
    </message>
    <message>
        <source>replay</source>
        <translation>Wiedergabe</translation>
    </message>
    <message>
        <source>preparing %1&#xa0;%: the tissue is that of %2 so far; earlier moments are shown at once</source>
        <translation>Vorbereitung %1&#xa0;%: das Gewebe ist das von %2; frühere Momente werden sofort gezeigt</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::ReportTexts</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Nothing can be said of the standing of people who follow a version of the curriculum that is not at this station: %1.</source>
        <translation>Nichts lässt sich zum Stand von Personen sagen, deren Version des Curriculums an dieser Station fehlt: %1.</translation>
    </message>
    <message>
        <source>DEMONSTRATION</source>
        <translation>VORFÜHRUNG</translation>
    </message>
    <message>
        <source>Performed by a simulated operator, not by a person.</source>
        <translation>Von einem simulierten Operateur durchgeführt, nicht von einer Person.</translation>
    </message>
    <message>
        <source>Performed in the demonstration, on the account of a synthetic person.</source>
        <translation>In der Vorführung durchgeführt, unter dem Konto einer synthetischen Person.</translation>
    </message>
    <message>
        <source>Provisional limits (of synthetic operators, or of the task itself): they allow &quot;passed (provisional)&quot;, never proficiency or a certificate.</source>
        <translation>Vorläufige Grenzwerte (von synthetischen Operateuren oder der Aufgabe selbst): Sie erlauben „bestanden (vorläufig)“, nie „sicher beherrscht“ und nie ein Zertifikat.</translation>
    </message>
    <message>
        <source>Practice from a moment of another attempt or of a demonstration: a part of the task, never scored.</source>
        <translation>Übung ab einem Zeitpunkt eines anderen Versuchs oder einer Vorführung: ein Teil der Aufgabe, nie ausgewertet.</translation>
    </message>
    <message>
        <source>Not scored: %1</source>
        <translation>Nicht ausgewertet: %1</translation>
    </message>
    <message>
        <source>gate</source>
        <translation>Kriterium</translation>
    </message>
    <message>
        <source>hand</source>
        <translation>Hand</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>met</source>
        <translation>erfüllt</translation>
    </message>
    <message>
        <source>not met</source>
        <translation>nicht erfüllt</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>nicht beurteilt</translation>
    </message>
    <message>
        <source>Pathology report (simulated)</source>
        <translation>Pathologiebericht (simuliert)</translation>
    </message>
    <message>
        <source>Attempt of %1, %2</source>
        <translation>Versuch von %1, %2</translation>
    </message>
    <message>
        <source>attempt %1</source>
        <translation>Versuch %1</translation>
    </message>
    <message>
        <source>Metrics: %1</source>
        <translation>Kennzahlen: %1</translation>
    </message>
    <message>
        <source>Benchmark sets: %1</source>
        <translation>Richtwertsätze: %1</translation>
    </message>
    <message>
        <source>program %1</source>
        <translation>Software %1</translation>
    </message>
    <message>
        <source>created %1 by %2 (%3)</source>
        <translation>erstellt %1 von %2 (%3)</translation>
    </message>
    <message>
        <source>audit %1</source>
        <translation>Protokoll %1</translation>
    </message>
    <message>
        <source>signed by key %1</source>
        <translation>signiert mit Schlüssel %1</translation>
    </message>
    <message>
        <source>nothing was cut</source>
        <translation>es wurde nichts geschnitten</translation>
    </message>
    <message>
        <source>%1 % of the plane was divided; a grade needs %2 %</source>
        <translation>%1 % der Schicht wurden durchtrennt; für einen Grad sind %2 % nötig</translation>
    </message>
    <message>
        <source>no defect deeper than 5 mm, no coning</source>
        <translation>kein Defekt tiefer als 5 mm, kein Coning</translation>
    </message>
    <message>
        <source>a defect of %1 mm, deeper than 5 mm</source>
        <translation>ein Defekt von %1 mm, tiefer als 5 mm</translation>
    </message>
    <message>
        <source>%1 % of the cut is more than 2 mm in the fat (limit %2 %)</source>
        <translation>%1 % des Schnitts liegen mehr als 2 mm im Fett (Grenzwert %2 %)</translation>
    </message>
    <message>
        <source>coning of %1 mm</source>
        <translation>Coning von %1 mm</translation>
    </message>
    <message>
        <source>a defect down to the muscularis</source>
        <translation>ein Defekt bis auf die Muscularis</translation>
    </message>
    <message>
        <source>half of the cut is more than %1 mm in the fat</source>
        <translation>die Hälfte des Schnitts liegt mehr als %1 mm im Fett</translation>
    </message>
    <message>
        <source>coning of %1 mm, more than %2 mm</source>
        <translation>Coning von %1 mm, mehr als %2 mm</translation>
    </message>
    <message>
        <source>the bowel was perforated</source>
        <translation>der Darm wurde perforiert</translation>
    </message>
    <message>
        <source>Not gradable</source>
        <translation>Nicht einstufbar</translation>
    </message>
    <message>
        <source>Grade 3, complete</source>
        <translation>Grad 3, vollständig</translation>
    </message>
    <message>
        <source>Grade 2, nearly complete</source>
        <translation>Grad 2, nahezu vollständig</translation>
    </message>
    <message>
        <source>Grade 1, incomplete</source>
        <translation>Grad 1, unvollständig</translation>
    </message>
    <message>
        <source>; </source>
        <translation>; </translation>
    </message>
    <message>
        <source>Mesorectum</source>
        <translation>Mesorektum</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>Coning</source>
        <translation>Coning</translation>
    </message>
    <message>
        <source>Not assessed: fewer than three levels were at least half divided.</source>
        <translation>Nicht beurteilt: Weniger als drei Etagen waren mindestens zur Hälfte durchtrennt.</translation>
    </message>
    <message>
        <source>towards the rectum</source>
        <translation>zum Rektum hin</translation>
    </message>
    <message>
        <source>towards the sacrum</source>
        <translation>zum Sakrum hin</translation>
    </message>
    <message>
        <source>%1: from the first level to the last the cut moves %2 mm %3 (coning: more than %4 mm towards the rectum).</source>
        <translation>%1: Von der ersten bis zur letzten Etage verschiebt sich der Schnitt um %2 mm %3 (Coning: mehr als %4 mm zum Rektum hin).</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>Ja</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Nein</translation>
    </message>
    <message>
        <source>Defects</source>
        <translation>Defekte</translation>
    </message>
    <message>
        <source>None.</source>
        <translation>Keine.</translation>
    </message>
    <message>
        <source>%1: %2 mm deep, %3 mm wide, at %4</source>
        <translation>%1: %2 mm tief, %3 mm breit, bei %4</translation>
    </message>
    <message>
        <source>, down to the muscularis</source>
        <translation>, bis auf die Muscularis</translation>
    </message>
    <message>
        <source>and %1 shallower ones.</source>
        <translation>und %1 flachere.</translation>
    </message>
    <message>
        <source>Circumferential margin</source>
        <translation>Zirkumf. Rand (CRM)</translation>
    </message>
    <message>
        <source>The case has no tumour.</source>
        <translation>Der Fall hat keinen Tumor.</translation>
    </message>
    <message>
        <source>Not given: the plane next to the tumour was not divided.</source>
        <translation>Keine Angabe: Die Schicht neben dem Tumor wurde nicht durchtrennt.</translation>
    </message>
    <message>
        <source>%1 mm, %2 (positive: 1 mm or less). Tumour at %3, its edge %4 mm outside the muscularis.</source>
        <translation>%1 mm, %2 (positiv: 1 mm oder weniger). Tumor: %3, sein Rand %4 mm außerhalb der Muscularis.</translation>
    </message>
    <message>
        <source>positive</source>
        <translation>positiv</translation>
    </message>
    <message>
        <source>negative</source>
        <translation>negativ</translation>
    </message>
    <message>
        <source>Distal margin</source>
        <translation>Distaler Absetzungsrand</translation>
    </message>
    <message>
        <source>No transection was done in this task, and the dissection did not reach below the tumour.</source>
        <translation>In dieser Aufgabe wurde nicht abgesetzt, und die Dissektion reichte nicht unter den Tumor.</translation>
    </message>
    <message>
        <source>No transection was done in this task: the distal margin is the distance from the tumour&apos;s lower edge to the lowest level that was divided from side to side, %1 mm (level %2).</source>
        <translation>In dieser Aufgabe wurde nicht abgesetzt: Der distale Absetzungsrand ist der Abstand vom unteren Tumorrand bis zur untersten Etage, die von Seite zu Seite durchtrennt wurde, %1 mm (Etage %2).</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>midline</source>
        <translation>Mittellinie</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>level %1, %2</source>
        <translation>Etage %1, %2</translation>
    </message>
    <message>
        <source>Specimen</source>
        <translation>Präparat</translation>
    </message>
    <message>
        <source>Rectum in its mesorectal envelope, posterior sector, %1 levels; %2 % of the plane divided, not transected.</source>
        <translation>Rektum in seiner mesorektalen Hülle, hinterer Sektor, %1 Etagen; %2 % der Schicht durchtrennt, nicht abgesetzt.</translation>
    </message>
    <message>
        <source>Plane divided</source>
        <translation>Schicht durchtrennt</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>no tumour</source>
        <translation>kein Tumor</translation>
    </message>
    <message>
        <source>%1 mm, %2</source>
        <translation>%1 mm, %2</translation>
    </message>
    <message>
        <source>not given</source>
        <translation>keine Angabe</translation>
    </message>
    <message>
        <source>the plane next to the tumour was not divided</source>
        <translation>die Schicht neben dem Tumor wurde nicht durchtrennt</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>the dissection did not reach below the tumour</source>
        <translation>die Dissektion reichte nicht unter den Tumor</translation>
    </message>
    <message>
        <source>%1: not divided.</source>
        <translation>%1: nicht durchtrennt.</translation>
    </message>
    <message>
        <source>%1: %2 % divided. Distance from the plane: median %3 mm, 95th percentile %4 mm; %5 % of the cut within %6 mm of the plane, %7 % too deep (towards the sacrum), %8 % too shallow (into the mesorectum).</source>
        <translation>%1: %2 % durchtrennt. Abstand zur Schicht: Median %3 mm, 95. Perzentil %4 mm; %5 % des Schnitts innerhalb von %6 mm um die Schicht, %7 % zu tief (zum Sakrum hin), %8 % zu flach (ins Mesorektum hinein).</translation>
    </message>
    <message>
        <source> Deepest defect %1 mm.</source>
        <translation> Tiefster Defekt %1 mm.</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Etage</translation>
    </message>
    <message>
        <source>Sector</source>
        <translation>Sektor</translation>
    </message>
    <message>
        <source>Divided %</source>
        <translation>Getrennt %</translation>
    </message>
    <message>
        <source>Median mm</source>
        <translation>Median mm</translation>
    </message>
    <message>
        <source>95th mm</source>
        <translation>P95 mm</translation>
    </message>
    <message>
        <source>Worst mm</source>
        <translation>Größter mm</translation>
    </message>
    <message>
        <source>In plane %</source>
        <translation>In Schicht %</translation>
    </message>
    <message>
        <source>Deep %</source>
        <translation>Tief %</translation>
    </message>
    <message>
        <source>Shallow %</source>
        <translation>Flach %</translation>
    </message>
    <message>
        <source>Defect mm</source>
        <translation>Defekt mm</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>Levels from cranial to caudal, sides of the patient. Distances of the cut from the intended plane: median and 95th percentile of their size; the worst is positive towards the sacrum (too deep), negative into the mesorectum (too shallow); in plane within %1 mm. Simulated: from the cut surface of this attempt at rest.</source>
        <translation>Etagen von kranial nach kaudal, Seiten des Patienten. Abstände des Schnitts von der vorgesehenen Schicht: Median und 95. Perzentil (P95) ihres Betrags; der größte ist positiv zum Sakrum hin (zu tief), negativ ins Mesorektum hinein (zu flach); in der Schicht: innerhalb von %1 mm. Simuliert: aus der Schnittfläche dieses Versuchs in Ruhe.</translation>
    </message>
    <message>
        <source> The task asks for %1 of %2 mm of the line; shares divided are of that.</source>
        <translation> Die Aufgabe verlangt %1 von %2 mm der Linie; darauf beziehen sich die durchtrennten Anteile.</translation>
    </message>
    <message>
        <source>passed (provisional)</source>
        <translation>bestanden (vorläufig)</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>attempted</source>
        <translation>begonnen</translation>
    </message>
    <message>
        <source>not attempted</source>
        <translation>nicht begonnen</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Synthetic: the people in this report are not real.</source>
        <translation>Synthetisch: Die Personen in diesem Bericht sind nicht real.</translation>
    </message>
    <message>
        <source>n = %1 counting attempts</source>
        <translation>n = %1 gewertete Versuche</translation>
    </message>
    <message>
        <source>progress report</source>
        <translation>Fortschrittsbericht</translation>
    </message>
    <message>
        <source>task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>state</source>
        <translation>Status</translation>
    </message>
    <message>
        <source>attempts</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>other</source>
        <translation>andere</translation>
    </message>
    <message>
        <source>best</source>
        <translation>beste</translation>
    </message>
    <message>
        <source>No attempts yet.</source>
        <translation>Noch keine Versuche.</translation>
    </message>
    <message>
        <source>attempts %1 · best %2</source>
        <translation>Versuche %1 · Bestwert %2</translation>
    </message>
    <message>
        <source>%1 · attempts %2 · best %3</source>
        <translation>%1 · Versuche %2 · Bestwert %3</translation>
    </message>
    <message>
        <source>people: n = %1</source>
        <translation>Personen: n = %1</translation>
    </message>
    <message>
        <source>deactivated: %1</source>
        <translation>deaktiviert: %1</translation>
    </message>
    <message>
        <source>%1 synthetic people left out</source>
        <translation>%1 synthetische Personen ausgelassen</translation>
    </message>
    <message>
        <source>cohort report</source>
        <translation>Gruppenbericht</translation>
    </message>
    <message>
        <source>person</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>Progress of %1</source>
        <translation>Fortschritt von %1</translation>
    </message>
    <message>
        <source>Cohort %1</source>
        <translation>Gruppe %1</translation>
    </message>
    <message>
        <source>cranial</source>
        <translation>kranial</translation>
    </message>
    <message>
        <source>caudal</source>
        <translation>kaudal</translation>
    </message>
    <message>
        <source>level %1</source>
        <translation>Etage %1</translation>
    </message>
    <message>
        <source>to %1</source>
        <translation>bis %1</translation>
    </message>
    <message>
        <source>&gt; %1</source>
        <translation>&gt; %1</translation>
    </message>
    <message>
        <source>Colour: 95 % of the sector&apos;s cut is no further from the plane (mm). ▼ towards the sacrum, too deep. ▲ into the mesorectum, too shallow. Hatched: not divided. Notches: defects in the fat, with their depth (mm).</source>
        <translation>Farbe: 95 % des Schnitts im Sektor liegen nicht weiter von der Schicht entfernt (mm). ▼ zum Sakrum hin, zu tief. ▲ ins Mesorektum hinein, zu flach. Schraffiert: nicht durchtrennt. Kerben: Defekte im Fett mit ihrer Tiefe (mm).</translation>
    </message>
    <message>
        <source>tumour</source>
        <translation>Tumor</translation>
    </message>
    <message>
        <source>item</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>total</source>
        <translation>Summe</translation>
    </message>
    <message>
        <source>Ratings with observer forms</source>
        <translation>Beurteilungen mit Beurteilungsbögen</translation>
    </message>
    <message>
        <source>report on one attempt</source>
        <translation>Bericht zu einem Versuch</translation>
    </message>
    <message>
        <source>account %1</source>
        <translation>Anmeldename %1</translation>
    </message>
    <message>
        <source>data up to %1</source>
        <translation>Stand %1</translation>
    </message>
    <message>
        <source>Ratings by observers</source>
        <translation>Beurteilungen</translation>
    </message>
    <message>
        <source>attempt of</source>
        <translation>Versuch vom</translation>
    </message>
    <message>
        <source>form</source>
        <translation>Bogen</translation>
    </message>
    <message>
        <source>raters</source>
        <translation>Beurteilende</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>%1: %2, attempts %3</source>
        <translation>%1: %2, Versuche %3</translation>
    </message>
    <message>
        <source>attempt signed by key %1</source>
        <translation>Versuch signiert mit Schlüssel %1</translation>
    </message>
    <message>
        <source>Files (sha256): %1</source>
        <translation>Dateien (sha256): %1</translation>
    </message>
    <message>
        <source>Files: %1, sha256 of their list %2</source>
        <translation>Dateien: %1, sha256 ihrer Liste %2</translation>
    </message>
    <message>
        <source>not tamper-evident (manual: Who can change the store)</source>
        <translation>Eingriffe nicht erkennbar (Handbuch: Who can change the store)</translation>
    </message>
    <message>
        <source>Voided by %1 on %2: %3. It does not count.</source>
        <translation>Für ungültig erklärt von %1 am %2: %3. Er zählt nicht.</translation>
    </message>
    <message>
        <source>A copy was stored for the person who performed it.</source>
        <translation>Für die Person, die ihn durchgeführt hat, wurde eine Kopie gespeichert.</translation>
    </message>
    <message>
        <source>%1 (sha256 %2)</source>
        <translation>%1 (sha256 %2)</translation>
    </message>
    <message>
        <source>Practised with files that are neither part of this program nor accepted by the programme: %1. Its values cannot be compared with those of other attempts.</source>
        <translation>Geübt mit Dateien, die weder zu dieser Software gehören noch vom Programm anerkannt sind: %1. Die Werte lassen sich nicht mit denen anderer Versuche vergleichen.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::ScenePicture</name>
    <message>
        <source>What the scope sees when %1 begins</source>
        <translation>Was die Optik sieht, wenn %1 beginnt</translation>
    </message>
    <message>
        <source>drawing the scene …</source>
        <translation>Szene wird gezeichnet …</translation>
    </message>
    <message>
        <source>No picture: %1</source>
        <translation>Kein Bild: %1</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::ScheduleWatch</name>
    <message>
        <source>The scheduled report of %1 was not written: %2</source>
        <translation>Der geplante Bericht von %1 wurde nicht geschrieben: %2</translation>
    </message>
    <message>
        <source>A scheduled report was written: %1</source>
        <translation>Ein geplanter Bericht wurde geschrieben: %1</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::SchedulesPage</name>
    <message>
        <source>every day</source>
        <translation>jeden Tag</translation>
    </message>
    <message>
        <source>every week</source>
        <translation>jede Woche</translation>
    </message>
    <message>
        <source>Reports</source>
        <translation>Berichte</translation>
    </message>
    <message>
        <source>Scheduled reports</source>
        <translation>Geplante Berichte</translation>
    </message>
    <message>
        <source>Cohort</source>
        <translation>Kohorte</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>How often</source>
        <translation>Wie oft</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Last written</source>
        <translation>Zuletzt geschrieben</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Folder of the reports</source>
        <translation>Ordner der Berichte</translation>
    </message>
    <message>
        <source>Folder, such as /srv/reports</source>
        <translation>Ordner, zum Beispiel /srv/reports</translation>
    </message>
    <message>
        <source>Folder …</source>
        <translation>Ordner …</translation>
    </message>
    <message>
        <source>Files for research</source>
        <translation>Dateien für die Forschung</translation>
    </message>
    <message>
        <source>Folder of the files for research</source>
        <translation>Ordner der Dateien für die Forschung</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nie</translation>
    </message>
    <message>
        <source>✕ failed: %1</source>
        <translation>✕ misslungen: %1</translation>
    </message>
    <message>
        <source>● due</source>
        <translation>● fällig</translation>
    </message>
    <message>
        <source>✓ written</source>
        <translation>✓ geschrieben</translation>
    </message>
    <message>
        <source>Make a cohort first, on the page Assign cohorts.</source>
        <translation>Legen Sie zuerst eine Kohorte an, auf der Seite Kohorten zuordnen.</translation>
    </message>
    <message>
        <source>Scheduled.</source>
        <translation>Geplant.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message numerus="yes">
        <source>%n files written.</source>
        <translation>
            <numerusform>%n Datei geschrieben.</numerusform>
            <numerusform>%n Dateien geschrieben.</numerusform>
        </translation>
    </message>
    <message>
        <source>Writing the report …</source>
        <translation>Der Bericht wird geschrieben …</translation>
    </message>
    <message>
        <source>%1 is not a folder. Choose an existing one.</source>
        <translation>%1 ist kein Ordner. Wählen Sie einen vorhandenen.</translation>
    </message>
    <message>
        <source>%1 files written: %2 attempts of %3 people; %4 left out, of tasks with too few people.</source>
        <translation>%1 Dateien geschrieben: %2 Versuche von %3 Personen; %4 weggelassen, von Aufgaben mit zu wenigen Personen.</translation>
    </message>
    <message>
        <source>Writing the files …</source>
        <translation>Die Dateien werden geschrieben …</translation>
    </message>
    <message>
        <source>This station writes a report of a cohort to a folder every day or week (UTC). It does so while a director is signed in, or when the command &quot;fulcrum schedule run&quot; is run.</source>
        <translation>Diese Station schreibt jeden Tag oder jede Woche (UTC) einen Bericht über eine Gruppe in einen Ordner. Sie tut es, während eine Leitung angemeldet ist, oder durch den Befehl „fulcrum schedule run“.</translation>
    </message>
    <message>
        <source>No report is scheduled yet. Add one below.</source>
        <translation>Noch ist kein Bericht geplant. Fügen Sie unten einen hinzu.</translation>
    </message>
    <message>
        <source>Write reports that are due</source>
        <translation>Fällige Berichte schreiben</translation>
    </message>
    <message>
        <source>Write selected report now</source>
        <translation>Gewählten Bericht jetzt schreiben</translation>
    </message>
    <message>
        <source>Remove schedule</source>
        <translation>Planung entfernen</translation>
    </message>
    <message>
        <source>Add a scheduled report</source>
        <translation>Einen geplanten Bericht hinzufügen</translation>
    </message>
    <message>
        <source>Add report</source>
        <translation>Bericht hinzufügen</translation>
    </message>
    <message>
        <source>Folder that exists</source>
        <translation>Ein vorhandener Ordner</translation>
    </message>
    <message>
        <source>Write files</source>
        <translation>Dateien schreiben</translation>
    </message>
    <message>
        <source>(cohort no longer exists)</source>
        <translation>(die Gruppe gibt es nicht mehr)</translation>
    </message>
    <message>
        <source>Another program is already writing the reports that are due.</source>
        <translation>Ein anderes Programm schreibt die fälligen Berichte bereits.</translation>
    </message>
    <message>
        <source>All attempts of the programme without names, dates and exact values: five CSV files with a dictionary. Devices, modes, tasks and metrics of fewer than 5 people are put together or left out, and the two tables of counts, taken alone, give no count below 5. The files attempts and metrics have rows of single people, from which smaller counts follow, and a reader who knows a person&apos;s attempts well might recognise that person: give them to researchers only and do not publish them. Give the same readers no later export without need: next to an earlier one it shows what single people did in between.</source>
        <translation>Alle Versuche des Programms ohne Namen, Daten und genaue Werte: fünf CSV-Dateien mit Datenverzeichnis. Geräte, Modi, Aufgaben und Kennzahlen von weniger als 5 Personen sind zusammengefasst oder fehlen, und die beiden Tabellen mit Anzahlen ergeben für sich allein keine Anzahl unter 5. Die Dateien attempts und metrics haben Zeilen einzelner Personen, aus denen kleinere Anzahlen folgen, und wer die Versuche einer Person gut kennt, könnte sie erkennen: Geben Sie sie nur an Forschende, und veröffentlichen Sie sie nicht. Geben Sie denselben Lesern nicht ohne Not einen späteren Export: Neben einem früheren zeigt er, was einzelne Personen dazwischen getan haben.</translation>
    </message>
    <message>
        <source>a scheduled report that is not added yet</source>
        <translation>ein geplanter Bericht, der noch nicht angelegt ist</translation>
    </message>
    <message>
        <source>Remove this schedule for good</source>
        <translation>Diese Planung endgültig entfernen</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::SendingCard</name>
    <message>
        <source>Send attempts to other programs</source>
        <translation>Versuche an andere Programme senden</translation>
    </message>
    <message>
        <source>OpenIGTLink</source>
        <translation>OpenIGTLink</translation>
    </message>
    <message>
        <source>At %1; programs connected: %2</source>
        <translation>Unter %1; verbundene Programme: %2</translation>
    </message>
    <message>
        <source>Connections closed because the program read too slowly or sent something else: %1</source>
        <translation>Verbindungen, die geschlossen wurden, weil das Programm zu langsam las oder etwas anderes sendete: %1</translation>
    </message>
    <message>
        <source>The environment variable FULCRUM_OPENIGTLINK names the address when Fulcrum starts.</source>
        <translation>Die Umgebungsvariable FULCRUM_OPENIGTLINK nennt beim Start von Fulcrum die Adresse.</translation>
    </message>
    <message>
        <source>Programs on other computers can connect, without a password.</source>
        <translation>Programme auf anderen Computern können sich verbinden, ohne Passwort.</translation>
    </message>
    <message>
        <source>Only programs on this computer can connect.</source>
        <translation>Nur Programme auf diesem Computer können sich verbinden.</translation>
    </message>
    <message>
        <source>For example to 3D Slicer: positions of the instruments and the camera, and forces, 60 times a second. No names are sent.</source>
        <translation>Zum Beispiel an 3D Slicer: Lagen der Instrumente und der Kamera sowie Kräfte, 60-mal pro Sekunde. Namen werden nicht gesendet.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::ServerCard</name>
    <message>
        <source>an enrolment of this station that is not complete yet</source>
        <translation>eine Aufnahme dieser Station, die noch nicht abgeschlossen ist</translation>
    </message>
    <message>
        <source>Programme server</source>
        <translation>Programmserver</translation>
    </message>
    <message>
        <source>The stations of a programme exchange people, attempts and reviews through its server. This station works without it, too, and sends what is new at the next exchange.</source>
        <translation>Die Stationen eines Programms tauschen Personen, Versuche und Beurteilungen über seinen Server aus. Diese Station arbeitet auch ohne ihn und sendet beim nächsten Abgleich, was neu ist.</translation>
    </message>
    <message>
        <source>Exchange now</source>
        <translation>Jetzt abgleichen</translation>
    </message>
    <message>
        <source>Enrol again …</source>
        <translation>Neu aufnehmen …</translation>
    </message>
    <message>
        <source>With another token of the server&apos;s owner: for other cohorts, or where the password of the station&apos;s account was lost.</source>
        <translation>Mit einem weiteren Token vom Eigentümer des Servers: für andere Gruppen, oder wenn das Passwort des Kontos der Station verloren ist.</translation>
    </message>
    <message>
        <source>The server&apos;s owner makes a token with &quot;fulcrum server enrol&quot; and tells you its address. A token is good for one station, once, and for some days.</source>
        <translation>Der Eigentümer des Servers erzeugt ein Token mit „fulcrum server enrol“ und nennt Ihnen die Adresse. Ein Token gilt für eine Station, einmal und einige Tage lang.</translation>
    </message>
    <message>
        <source>Address of the server</source>
        <translation>Adresse des Servers</translation>
    </message>
    <message>
        <source>Token, such as 0A1B2-…</source>
        <translation>Token, etwa 0A1B2-…</translation>
    </message>
    <message>
        <source>Token</source>
        <translation>Token</translation>
    </message>
    <message>
        <source>Enrol this station</source>
        <translation>Diese Station aufnehmen</translation>
    </message>
    <message>
        <source>Enrolled at %1</source>
        <translation>Aufgenommen bei %1</translation>
    </message>
    <message>
        <source>Gets everybody of the programme.</source>
        <translation>Bekommt alle Personen des Programms.</translation>
    </message>
    <message>
        <source>Gets the people of: %1</source>
        <translation>Bekommt die Personen von: %1</translation>
    </message>
    <message>
        <source>Nothing was exchanged yet.</source>
        <translation>Noch nichts abgeglichen.</translation>
    </message>
    <message>
        <source>Last exchange with something new: %1</source>
        <translation>Letzter Abgleich mit etwas Neuem: %1</translation>
    </message>
    <message>
        <source>Enrolling, then exchanging …</source>
        <translation>Aufnehmen, dann abgleichen …</translation>
    </message>
    <message>
        <source>Exchanging …</source>
        <translation>Abgleichen …</translation>
    </message>
    <message>
        <source>Stopped before the end. Nothing is lost; the next exchange completes it.</source>
        <translation>Vor dem Ende angehalten. Nichts ist verloren; der nächste Abgleich macht es fertig.</translation>
    </message>
    <message>
        <source>✓ Station and server agree already.</source>
        <translation>✓ Station und Server stimmen schon überein.</translation>
    </message>
    <message>
        <source>✓ Station and server agree: %1 records sent, %2 received.</source>
        <translation>✓ Station und Server stimmen überein: %1 Datensätze gesendet, %2 empfangen.</translation>
    </message>
    <message numerus="yes">
        <source>%n person(s) were erased here, as on the server.</source>
        <translation>
            <numerusform>%n Person wurde hier gelöscht, wie auf dem Server.</numerusform>
            <numerusform>%n Personen wurden hier gelöscht, wie auf dem Server.</numerusform>
        </translation>
    </message>
    <message>
        <source>The clocks of station and server differ by %1 s: set this one.</source>
        <translation>Die Uhren von Station und Server weichen um %1 s voneinander ab: Stellen Sie diese.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::SettingsPage</name>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Text size</source>
        <translation>Schriftgröße</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>The environment variable FULCRUM_LANGUAGE chooses the language of this station. Start Fulcrum without it to choose here.</source>
        <translation>Die Umgebungsvariable FULCRUM_LANGUAGE legt die Sprache dieser Station fest. Starten Sie Fulcrum ohne sie, um hier zu wählen.</translation>
    </message>
    <message>
        <source>Settings are saved on this computer. All except the keys apply to everyone who uses this account of the operating system.</source>
        <translation>Die Einstellungen werden auf diesem Rechner gespeichert. Alle außer den Tasten gelten für jeden, der dieses Konto des Betriebssystems benutzt.</translation>
    </message>
    <message>
        <source>During an attempt, the text over the picture grows only as far as there is room.</source>
        <translation>Während eines Versuchs wächst die Schrift über dem Bild nur, soweit dort Platz ist.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::SignInPage</name>
    <message>
        <source>a new password</source>
        <translation>ein neues Passwort</translation>
    </message>
    <message>
        <source>Sign in</source>
        <translation>Anmelden</translation>
    </message>
    <message>
        <source>Login</source>
        <translation>Anmeldename</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Passwort</translation>
    </message>
    <message>
        <source>Forgotten password?</source>
        <translation>Passwort vergessen?</translation>
    </message>
    <message>
        <source>Recently signed in here</source>
        <translation>Zuletzt hier angemeldet</translation>
    </message>
    <message>
        <source>Forgotten password</source>
        <translation>Passwort vergessen</translation>
    </message>
    <message>
        <source>An administrator can give you a one-time password, valid for 24 hours. The last administrator uses the recovery code instead:</source>
        <translation>Ein Administrator kann Ihnen ein Einmalpasswort geben, das 24 Stunden gilt. Der letzte Administrator verwendet stattdessen den Wiederherstellungscode:</translation>
    </message>
    <message>
        <source>Administrator&apos;s login</source>
        <translation>Anmeldename (Administrator)</translation>
    </message>
    <message>
        <source>Recovery code</source>
        <translation>Wiederherstellungscode</translation>
    </message>
    <message>
        <source>New password</source>
        <translation>Neues Passwort</translation>
    </message>
    <message>
        <source>Set the new password</source>
        <translation>Neues Passwort setzen</translation>
    </message>
    <message>
        <source>Look around as</source>
        <translation>Umsehen als</translation>
    </message>
    <message>
        <source>Leave the demonstration</source>
        <translation>Vorführung verlassen</translation>
    </message>
    <message>
        <source>Demonstration programme</source>
        <translation>Vorführprogramm</translation>
    </message>
    <message>
        <source>%1 — %2</source>
        <translation>%1 — %2</translation>
    </message>
    <message>
        <source>Signing in …</source>
        <translation>Anmeldung läuft …</translation>
    </message>
    <message>
        <source>Checking the recovery code …</source>
        <translation>Wiederherstellungscode wird geprüft …</translation>
    </message>
    <message numerus="yes">
        <source>Educators and the director see %n more trainee(s).</source>
        <translation>
            <numerusform>Ausbilder und Leitung sehen %n weitere lernende Person.</numerusform>
            <numerusform>Ausbilder und Leitung sehen %n weitere Lernende.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempts were running when the program last ended. They are listed as interrupted; everything recorded until then is kept.</source>
        <translation>
            <numerusform>%n Versuch lief noch, als das Programm zuletzt endete. Er ist als unterbrochen aufgeführt; alles bis dahin Aufgezeichnete bleibt erhalten.</numerusform>
            <numerusform>%n Versuche liefen noch, als das Programm zuletzt endete. Sie sind als unterbrochen aufgeführt; alles bis dahin Aufgezeichnete bleibt erhalten.</numerusform>
        </translation>
    </message>
    <message>
        <source>Enter your login and your password.</source>
        <translation>Geben Sie Ihren Anmeldenamen und Ihr Passwort ein.</translation>
    </message>
    <message>
        <source>Your new recovery code</source>
        <translation>Ihr neuer Wiederherstellungscode</translation>
    </message>
    <message>
        <source>The password was changed. The code that you used no longer works, and this one is shown only once. Write it down and lock it away: without it, the last administrator cannot set a new password.</source>
        <translation>Das Passwort wurde geändert. Der verwendete Code gilt nicht mehr, und dieser wird nur einmal angezeigt. Schreiben Sie ihn auf und schließen Sie ihn weg: Ohne ihn kann der letzte Administrator kein neues Passwort setzen.</translation>
    </message>
    <message>
        <source>I have written it down</source>
        <translation>Ich habe ihn aufgeschrieben</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::SolidTexts</name>
    <message>
        <source>from behind</source>
        <translation>von hinten</translation>
    </message>
    <message>
        <source>from the front (not judged)</source>
        <translation>von vorn (nicht beurteilt)</translation>
    </message>
    <message>
        <source>from the patient&apos;s right</source>
        <translation>von der rechten Seite des Patienten</translation>
    </message>
    <message>
        <source>from the patient&apos;s left</source>
        <translation>von der linken Seite des Patienten</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::SoundCard</name>
    <message>
        <source>Sound during tasks</source>
        <translation>Ton während der Aufgaben</translation>
    </message>
    <message>
        <source>Play the sounds</source>
        <translation>Töne abspielen</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Lautstärke</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>A click for each contact, a tone that rises with force beyond a tissue&apos;s limit, a hum while energy is on, and two tones once a second while tissue bleeds faster than 10 mL/min. The left hand is louder on the left.</source>
        <translation>Ein Klick bei jeder Berührung, ein Ton, der mit der Kraft über der Grenze eines Gewebes steigt, ein Brummen, solange Energie an ist, und einmal pro Sekunde zwei Töne, solange Gewebe schneller als 10 mL/min blutet. Die linke Hand ist links lauter.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::SpecimenSolid</name>
    <message>
        <source>Specimen in three dimensions</source>
        <translation>Präparat in drei Dimensionen</translation>
    </message>
    <message>
        <source>Seen %1. Arrow keys turn it, Home turns it back.</source>
        <translation>Ansicht %1. Die Pfeiltasten drehen es, Pos1 dreht es zurück.</translation>
    </message>
    <message>
        <source>seen %1</source>
        <translation>Ansicht %1</translation>
    </message>
    <message>
        <source>drag or use the arrow keys to turn it</source>
        <translation>zum Drehen ziehen oder die Pfeiltasten benutzen</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::SpecimenView</name>
    <message>
        <source>Specimen map</source>
        <translation>Karte des Präparats</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::StagesForm</name>
    <message>
        <source>Title of the curriculum</source>
        <translation>Titel des Curriculums</translation>
    </message>
    <message>
        <source>Stages, in the order in which they are learned</source>
        <translation>Stufen, in der Reihenfolge des Lernens</translation>
    </message>
    <message>
        <source>Short name</source>
        <translation>Kurzname</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Stages</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>Add a stage</source>
        <translation>Stufe hinzufügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>▲ Up</source>
        <translation>▲ Auf</translation>
    </message>
    <message>
        <source>▼ Down</source>
        <translation>▼ Ab</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::StandingCard</name>
    <message>
        <source>Decision</source>
        <translation>Entscheidung</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Decide</source>
        <translation>Entscheiden</translation>
    </message>
    <message>
        <source>Unlocked by %1 on %2: %3</source>
        <translation>Entsperrt von %1 am %2: %3</translation>
    </message>
    <message>
        <source>Declared proficient by %1 on %2: %3</source>
        <translation>Für sicher beherrscht erklärt von %1 am %2: %3</translation>
    </message>
    <message>
        <source>Check confirmed by %1 on %2: %3</source>
        <translation>Kontrolle bestätigt von %1 am %2: %3</translation>
    </message>
    <message>
        <source>Confirm the check</source>
        <translation>Kontrolle bestätigen</translation>
    </message>
    <message>
        <source>%1 (changed nothing: the task was not locked)</source>
        <translation>%1 (änderte nichts: Die Aufgabe war nicht gesperrt)</translation>
    </message>
    <message>
        <source>%1 (changed nothing: proficient already, and no check was due)</source>
        <translation>%1 (änderte nichts: schon sicher beherrscht, und keine Kontrolle war fällig)</translation>
    </message>
    <message>
        <source>The decision changed nothing.</source>
        <translation>Die Entscheidung hat nichts geändert.</translation>
    </message>
    <message>
        <source>%1 (does not count: both accounts are one person&apos;s)</source>
        <translation>%1 (zählt nicht: beide Konten gehören einer Person)</translation>
    </message>
    <message>
        <source>The check is confirmed.</source>
        <translation>Die Kontrolle ist bestätigt.</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Entsperren</translation>
    </message>
    <message>
        <source>Declare proficient</source>
        <translation>Für beherrscht erklären</translation>
    </message>
    <message>
        <source>Enter a reason.</source>
        <translation>Geben Sie einen Grund an.</translation>
    </message>
    <message>
        <source>The task is unlocked.</source>
        <translation>Die Aufgabe ist entsperrt.</translation>
    </message>
    <message>
        <source>Declared proficient.</source>
        <translation>Für sicher beherrscht erklärt.</translation>
    </message>
    <message>
        <source>Reason (kept in the audit log)</source>
        <translation>Grund (steht im Protokoll)</translation>
    </message>
    <message>
        <source>a reason for a decision</source>
        <translation>ein Grund für eine Entscheidung</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::StationPage</name>
    <message>
        <source>Station</source>
        <translation>Arbeitsplatz</translation>
    </message>
    <message>
        <source>Back up</source>
        <translation>Sichern</translation>
    </message>
    <message>
        <source>Back up …</source>
        <translation>Sichern …</translation>
    </message>
    <message>
        <source>Check the store</source>
        <translation>Datenbestand prüfen</translation>
    </message>
    <message>
        <source>Checked</source>
        <translation>Geprüft</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>What is wrong</source>
        <translation>Was nicht stimmt</translation>
    </message>
    <message>
        <source>The store: %1</source>
        <translation>Datenbestand: %1</translation>
    </message>
    <message>
        <source>Checking the store …</source>
        <translation>Datenbestand wird geprüft …</translation>
    </message>
    <message>
        <source>✓ The store is intact.</source>
        <translation>✓ Der Datenbestand ist unversehrt.</translation>
    </message>
    <message>
        <source>✓ intact</source>
        <translation>✓ unversehrt</translation>
    </message>
    <message>
        <source>✕ damaged</source>
        <translation>✕ beschädigt</translation>
    </message>
    <message>
        <source>Back up to</source>
        <translation>Sichern unter</translation>
    </message>
    <message>
        <source>Store (*.db)</source>
        <translation>Datenbestand (*.db)</translation>
    </message>
    <message>
        <source>Backed up to %1</source>
        <translation>Gesichert unter %1</translation>
    </message>
    <message>
        <source>Backing up …</source>
        <translation>Sicherung läuft …</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Schlüssel</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Change the key</source>
        <translation>Schlüssel wechseln</translation>
    </message>
    <message>
        <source>in use</source>
        <translation>in Gebrauch</translation>
    </message>
    <message>
        <source>The station signs with the key %1 from now on. Keep a copy of its file.</source>
        <translation>Der Arbeitsplatz unterschreibt von jetzt an mit dem Schlüssel %1. Bewahren Sie eine Kopie seiner Datei auf.</translation>
    </message>
    <message>
        <source>Copies the whole store into one file; you can continue to work. Keep the file on another disk. It is as confidential as the store itself.</source>
        <translation>Kopiert den ganzen Datenbestand in eine einzige Datei; Sie können weiterarbeiten. Bewahren Sie die Datei auf einem anderen Datenträger auf. Sie ist so vertraulich wie der Datenbestand selbst.</translation>
    </message>
    <message>
        <source>Check for damage</source>
        <translation>Auf Schäden prüfen</translation>
    </message>
    <message>
        <source>Number checked</source>
        <translation>Geprüfte Anzahl</translation>
    </message>
    <message>
        <source>Signing key</source>
        <translation>Signaturschlüssel</translation>
    </message>
    <message>
        <source>The station signs its audit log with this key, and every report names the key. Change it if the key&apos;s file may have been copied, or when a person with access to the file leaves. The old key signs the change, and everything it signed before stays valid.</source>
        <translation>Die Station signiert ihr Protokoll mit diesem Schlüssel, und jeder Bericht nennt ihn. Wechseln Sie ihn, wenn seine Datei kopiert worden sein kann oder wenn eine Person mit Zugang zu der Datei geht. Der alte Schlüssel signiert den Wechsel; was er vorher signiert hat, bleibt gültig.</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Herkunft</translation>
    </message>
    <message>
        <source>Reason for the change</source>
        <translation>Grund des Wechsels</translation>
    </message>
    <message>
        <source>first key</source>
        <translation>erster Schlüssel</translation>
    </message>
    <message>
        <source>✓ signed by the previous key</source>
        <translation>✓ vom vorigen Schlüssel signiert</translation>
    </message>
    <message>
        <source>✕ not signed by the previous key</source>
        <translation>✕ vom vorigen Schlüssel nicht unterschrieben</translation>
    </message>
    <message>
        <source>A backup can take the place of the store. You are signed out for that; the backup&apos;s administrator signs in, and what is in the store now is kept under another name.</source>
        <translation>Eine Sicherung kann an die Stelle des Datenbestands treten. Sie werden dafür abgemeldet; ein Administrator der Sicherung meldet sich an, und was jetzt im Datenbestand ist, bleibt unter einem anderen Namen erhalten.</translation>
    </message>
    <message>
        <source>Restore a backup …</source>
        <translation>Sicherung wiederherstellen …</translation>
    </message>
    <message>
        <source>✕ The store is damaged. Restore the newest backup: what is in the store now is kept under another name.</source>
        <translation>✕ Der Datenbestand ist beschädigt. Stellen Sie die neueste Sicherung wieder her: Was jetzt im Datenbestand ist, bleibt unter einem anderen Namen erhalten.</translation>
    </message>
    <message>
        <source>Reads the whole store (file pages, references, audit log, recordings and scores) and lists any damage. Then it simulates a few attempts again, drawn by chance, and compares them with their records, for at most 20 seconds. Nothing is changed.</source>
        <translation>Liest den ganzen Datenbestand (Seiten der Datei, Verweise, Protokoll, Aufzeichnungen und Bewertungen) und führt jeden Schaden auf. Dann werden einige zufällig gezogene Versuche erneut simuliert und mit ihren Aufzeichnungen verglichen, höchstens 20 Sekunden lang. Nichts wird geändert.</translation>
    </message>
    <message>
        <source>No attempt was simulated again: the line on simulation says why.</source>
        <translation>Kein Versuch wurde erneut simuliert: Die Zeile zur Simulation sagt, warum.</translation>
    </message>
    <message numerus="yes">
        <source>%n attempts were simulated again; all agree with their records.</source>
        <translation>
            <numerusform>%n Versuch wurde erneut simuliert; er stimmt mit seiner Aufzeichnung überein.</numerusform>
            <numerusform>%n Versuche wurden erneut simuliert; alle stimmen mit ihren Aufzeichnungen überein.</numerusform>
        </translation>
    </message>
    <message>
        <source>✕ The store can be read, but not every attempt that was simulated again agrees with its record (%1 simulated): %2. Such a record was replaced and signed with the station&apos;s key, or this computer has a hardware fault. Compare the attempt with an older backup, and change the key.</source>
        <translation>✕ Der Datenbestand ist lesbar, aber nicht jeder erneut simulierte Versuch stimmt mit seiner Aufzeichnung überein (%1 simuliert): %2. Eine solche Aufzeichnung wurde ersetzt und mit dem Schlüssel des Arbeitsplatzes signiert, oder dieser Rechner hat einen Hardwarefehler. Vergleichen Sie den Versuch mit einer älteren Sicherung und wechseln Sie den Schlüssel.</translation>
    </message>
    <message>
        <source>a reason for another key</source>
        <translation>ein Grund für einen anderen Schlüssel</translation>
    </message>
    <message>
        <source>Sign out and choose a backup</source>
        <translation>Abmelden und eine Sicherung wählen</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::StationsCard</name>
    <message>
        <source>Stations of the programme</source>
        <translation>Arbeitsplätze des Programms</translation>
    </message>
    <message>
        <source>Those whose attempts this station has. What another one did since its last exchange with the server is not known here.</source>
        <translation>Diejenigen, deren Versuche dieser Arbeitsplatz hat. Was ein anderer seit seinem letzten Austausch mit dem Server getan hat, ist hier nicht bekannt.</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>Arbeitsplatz</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Newest</source>
        <translation>Neuestes</translation>
    </message>
    <message>
        <source>Since</source>
        <translation>Seit</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Schlüssel</translation>
    </message>
    <message>
        <source>%1 (this one)</source>
        <translation>%1 (dieser)</translation>
    </message>
    <message>
        <source>nothing yet</source>
        <translation>noch nichts</translation>
    </message>
    <message>
        <source>not known here</source>
        <translation>hier nicht bekannt</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::TaskHeader</name>
    <message>
        <source>%1: not practised yet</source>
        <translation>%1: noch nicht geübt</translation>
    </message>
    <message>
        <source>%1: %3 of %2 attempts passed</source>
        <translation>%1: %3 von %2 Versuchen bestanden</translation>
    </message>
    <message>
        <source>Open the briefing</source>
        <translation>Einweisung öffnen</translation>
    </message>
    <message>
        <source>Open the briefing with this variant</source>
        <translation>Einweisung mit dieser Variante öffnen</translation>
    </message>
    <message>
        <source>Outcome: %1 · Time limit %2</source>
        <translation>Ergebnis: %1 · Zeitlimit %2</translation>
    </message>
    <message>
        <source>Watch an expert do it</source>
        <translation>Einem Experten zusehen</translation>
    </message>
    <message>
        <source>A simulated expert performs the task. Nothing is stored. Press Esc to stop.</source>
        <translation>Ein simulierter Experte führt die Aufgabe durch. Es wird nichts gespeichert. Drücken Sie Esc, um zu beenden.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::TaskNeedsForm</name>
    <message>
        <source>Stage</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Passes on variants, at least</source>
        <translation>Bestehen an Varianten, mindestens</translation>
    </message>
    <message>
        <source>Devices whose attempts count</source>
        <translation>Geräte, deren Versuche zählen</translation>
    </message>
    <message>
        <source>Prerequisites: proficient in all of these first</source>
        <translation>Voraussetzungen: zuerst alle diese beherrschen</translation>
    </message>
    <message>
        <source>Prerequisites</source>
        <translation>Voraussetzungen</translation>
    </message>
    <message numerus="yes">
        <source>Installed: %n variants</source>
        <translation>
            <numerusform>Installiert: %n Variante</numerusform>
            <numerusform>Installiert: %n Varianten</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (not in the curriculum)</source>
        <translation>%1 (nicht im Curriculum)</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::TaskRatingsForm</name>
    <message>
        <source>Ratings by observers are needed as well</source>
        <translation>Bewertungen durch Beobachtende sind ebenfalls nötig</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Bogen</translation>
    </message>
    <message>
        <source>Raters, at least</source>
        <translation>Bewertende, mindestens</translation>
    </message>
    <message>
        <source>Lowest mean, on the scale of the items</source>
        <translation>Niedrigster Mittelwert, auf der Skala der Punkte</translation>
    </message>
    <message>
        <source>Each item reaches this mean</source>
        <translation>Jeder Punkt erreicht diesen Mittelwert</translation>
    </message>
    <message>
        <source>Only blind ratings count</source>
        <translation>Nur blinde Bewertungen zählen</translation>
    </message>
    <message>
        <source>%1 (not installed)</source>
        <translation>%1 (nicht installiert)</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::TheatrePage</name>
    <message>
        <source>Pause (Esc)</source>
        <translation>Pause (Esc)</translation>
    </message>
    <message>
        <source>Keys (F1)</source>
        <translation>Tasten (F1)</translation>
    </message>
    <message>
        <source>Abandon …</source>
        <translation>Abbrechen …</translation>
    </message>
    <message>
        <source>Abandon the attempt</source>
        <translation>Versuch abbrechen</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Preparing the scene …</source>
        <translation>Szene wird vorbereitet …</translation>
    </message>
    <message>
        <source>The attempt did not begin</source>
        <translation>Der Versuch hat nicht begonnen</translation>
    </message>
    <message>
        <source>The scene cannot be drawn on this machine: %1. Nothing was stored.</source>
        <translation>Die Szene kann auf diesem Rechner nicht gezeichnet werden: %1. Es wurde nichts gespeichert.</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Geschlossen</translation>
    </message>
    <message>
        <source>The attempt had not begun; nothing was stored.</source>
        <translation>Der Versuch hatte nicht begonnen; es wurde nichts gespeichert.</translation>
    </message>
    <message>
        <source>The attempt was closed, counts as abandoned and is stored.</source>
        <translation>Der Versuch wurde geschlossen, gilt als abgebrochen und ist gespeichert.</translation>
    </message>
    <message>
        <source>The attempt was closed as interrupted and stored.</source>
        <translation>Der Versuch wurde als unterbrochen geschlossen und gespeichert.</translation>
    </message>
    <message>
        <source>Abandoned</source>
        <translation>Abgebrochen</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>Unterbrochen</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>The timer is stopped and the scene is hidden. The pause is recorded.</source>
        <translation>Die Uhr steht und die Szene ist verborgen. Die Pause wird aufgezeichnet.</translation>
    </message>
    <message>
        <source>Abandon this attempt?</source>
        <translation>Diesen Versuch abbrechen?</translation>
    </message>
    <message>
        <source>Storing the attempt …</source>
        <translation>Versuch wird gespeichert …</translation>
    </message>
    <message>
        <source>End the demonstration (Esc)</source>
        <translation>Vorführung beenden (Esc)</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Startseite</translation>
    </message>
    <message>
        <source>Two mice and keyboard</source>
        <translation>Zwei Mäuse und Tastatur</translation>
    </message>
    <message>
        <source>Mouse and keyboard</source>
        <translation>Maus und Tastatur</translation>
    </message>
    <message>
        <source>The attempt could not continue</source>
        <translation>Der Versuch konnte nicht weitergehen</translation>
    </message>
    <message>
        <source>The force is 0 and the timer is stopped; the recording is kept.</source>
        <translation>Die Kraft ist 0 und die Uhr steht; die Aufzeichnung bleibt erhalten.</translation>
    </message>
    <message>
        <source>Device lost</source>
        <translation>Geräteausfall</translation>
    </message>
    <message>
        <source>demonstration by a simulated expert</source>
        <translation>Vorführung durch einen simulierten Experten</translation>
    </message>
    <message>
        <source>%1 of %2 ticks missed</source>
        <translation>%1 von %2 Takten verpasst</translation>
    </message>
    <message>
        <source>the ghost of an expert waits for you</source>
        <translation>das Schattenbild eines Experten wartet auf Sie</translation>
    </message>
    <message>
        <source>Game controller</source>
        <translation>Gamecontroller</translation>
    </message>
    <message>
        <source>&lt;b&gt;F1&lt;/b&gt;&amp;nbsp;all keys</source>
        <translation>&lt;b&gt;F1&lt;/b&gt;&amp;nbsp;alle Tasten</translation>
    </message>
    <message>
        <source>This attempt is assessed and has begun. If you abandon it, it counts as failed. Everything recorded so far is kept.</source>
        <translation>Dieser Versuch wird bewertet und hat begonnen. Wenn Sie ihn abbrechen, gilt er als nicht bestanden. Alles bisher Aufgezeichnete bleibt erhalten.</translation>
    </message>
    <message>
        <source>This attempt is stored as abandoned and does not count.</source>
        <translation>Dieser Versuch wird als abgebrochen gespeichert und zählt nicht.</translation>
    </message>
    <message>
        <source>✓ %1 of %2 done</source>
        <translation>✓ %1 von %2 erledigt</translation>
    </message>
    <message>
        <source>&lt;b&gt;Enter&lt;/b&gt;&amp;nbsp;ends these lines</source>
        <translation>&lt;b&gt;Eingabe&lt;/b&gt;&amp;nbsp;beendet diese Zeilen</translation>
    </message>
    <message>
        <source>Enter	shows the first steps again</source>
        <translation>Eingabe	zeigt die ersten Schritte erneut</translation>
    </message>
    <message>
        <source>Bring the handles to where you begin</source>
        <translation>Bringen Sie die Griffe dorthin, wo Sie beginnen</translation>
    </message>
    <message>
        <source>Enter: begin where they are</source>
        <translation>Eingabe: dort beginnen, wo sie sind</translation>
    </message>
    <message>
        <source>Sound off (%1)</source>
        <translation>Ton aus (%1)</translation>
    </message>
    <message>
        <source>Sound on (%1)</source>
        <translation>Ton an (%1)</translation>
    </message>
    <message>
        <source>The demonstration was closed; nothing was stored.</source>
        <translation>Die Vorführung wurde geschlossen; es wurde nichts gespeichert.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::TheatreView</name>
    <message>
        <source>View through the laparoscope</source>
        <translation>Blick durch das Laparoskop</translation>
    </message>
    <message>
        <source>The picture cannot be drawn: %1</source>
        <translation>Das Bild kann nicht gezeichnet werden: %1</translation>
    </message>
    <message>
        <source>Preparing the scene …</source>
        <translation>Szene wird vorbereitet …</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::TimeChart</name>
    <message>
        <source>time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
    <message>
        <source>%1 s: %2</source>
        <translation>%1 s: %2</translation>
    </message>
    <message>
        <source>%1: highest %2 at %3 s</source>
        <translation>%1: höchster Wert %2 bei %3 s</translation>
    </message>
    <message>
        <source>%1, lower quarter</source>
        <translation>%1, unteres Viertel</translation>
    </message>
    <message>
        <source>%1, middle</source>
        <translation>%1, Mitte</translation>
    </message>
    <message>
        <source>%1, upper quarter</source>
        <translation>%1, oberes Viertel</translation>
    </message>
    <message>
        <source>In a chart, ← and → move through time, Page Up and Page Down go from mark to mark, + and − zoom, and 0 shows everything.</source>
        <translation>In einem Diagramm gehen ← und → durch die Zeit und Bild auf und Bild ab von Marke zu Marke; + und − zoomen, und 0 zeigt alles.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::TimeCharts</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::TissuesPage</name>
    <message>
        <source>above %1, at most %2</source>
        <translation>über %1, höchstens %2</translation>
    </message>
    <message>
        <source>at least %1, at most %2</source>
        <translation>mindestens %1, höchstens %2</translation>
    </message>
    <message>
        <source>scene value</source>
        <translation>Szenenwert</translation>
    </message>
    <message>
        <source>Tissue</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Aufgaben</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>In the scene</source>
        <translation>In der Szene</translation>
    </message>
    <message>
        <source>At this site</source>
        <translation>An diesem Standort</translation>
    </message>
    <message>
        <source>Allowed</source>
        <translation>Erlaubt</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Reset to the scene&apos;s values</source>
        <translation>Auf Werte der Szene zurücksetzen</translation>
    </message>
    <message>
        <source>Versions</source>
        <translation>Versionen</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>This site&apos;s values, version %1</source>
        <translation>Werte dieses Standorts, Version %1</translation>
    </message>
    <message>
        <source>The scene&apos;s values</source>
        <translation>Werte der Szene</translation>
    </message>
    <message>
        <source>%1, %2: &quot;%3&quot; is not a number. Enter a number %4 %5</source>
        <translation>%1, %2: „%3“ ist keine Zahl. Geben Sie eine Zahl ein: %4 %5</translation>
    </message>
    <message>
        <source>Saved. Attempts that begin from now on use these values.</source>
        <translation>Gespeichert. Versuche, die ab jetzt beginnen, verwenden diese Werte.</translation>
    </message>
    <message>
        <source>The scene&apos;s values apply again.</source>
        <translation>Es gelten wieder die Werte der Szene.</translation>
    </message>
    <message>
        <source>The force at which a blade cuts into and through a tissue. A change applies to attempts that begin afterwards; earlier attempts keep the values with which they were performed.</source>
        <translation>Die Kraft, bei der eine Klinge in ein Gewebe einschneidet und es durchtrennt. Eine Änderung gilt für Versuche, die danach beginnen; frühere behalten die Werte, mit denen sie durchgeführt wurden.</translation>
    </message>
    <message>
        <source>No task of this programme has tissue that can be cut.</source>
        <translation>Keine Aufgabe dieses Programms hat Gewebe, das geschnitten werden kann.</translation>
    </message>
    <message>
        <source>Reason (kept in the audit log)</source>
        <translation>Grund (steht im Protokoll)</translation>
    </message>
    <message>
        <source>Save values</source>
        <translation>Werte speichern</translation>
    </message>
    <message>
        <source>No values have been set at this site yet: those of the scene apply.</source>
        <translation>An diesem Standort sind noch keine Werte festgelegt: Es gelten die der Szene.</translation>
    </message>
    <message>
        <source>No attempt at this task can begin with these values: %1. Correct them, or reset them to the scene&apos;s values.</source>
        <translation>Mit diesen Werten kann kein Versuch an dieser Aufgabe beginnen: %1. Korrigieren Sie sie, oder setzen Sie sie auf die Werte der Szene zurück.</translation>
    </message>
    <message>
        <source>%1: attempts are not compared with the task&apos;s limits, and gates based on them are not scored: %2. Build a benchmark set in this tissue: fulcrum benchmark build %3 --operators --device-class %4 --db %5</source>
        <translation>%1: Versuche werden nicht mit den Grenzwerten der Aufgabe verglichen, und darauf beruhende Kriterien werden nicht bewertet: %2. Erstellen Sie einen Richtwertsatz mit diesem Gewebe: fulcrum benchmark build %3 --operators --device-class %4 --db %5</translation>
    </message>
    <message>
        <source>tissue values that are not saved</source>
        <translation>Gewebewerte, die nicht gespeichert sind</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::ToRatePage</name>
    <message>
        <source>Reading the attempts …</source>
        <translation>Die Versuche werden gelesen …</translation>
    </message>
    <message>
        <source>Rate attempts</source>
        <translation>Versuche beurteilen</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Variant</source>
        <translation>Variante</translation>
    </message>
    <message>
        <source>Started</source>
        <translation>Beginn</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Ratings</source>
        <translation>Beurteilungen</translation>
    </message>
    <message>
        <source>Blind</source>
        <translation>Blind</translation>
    </message>
    <message>
        <source>draft</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>● yes</source>
        <translation>● ja</translation>
    </message>
    <message>
        <source>● yes, by others</source>
        <translation>● ja, von anderen</translation>
    </message>
    <message>
        <source>The curriculum needs blind ratings of this attempt. You have seen name or score: yours would not count.</source>
        <translation>Das Curriculum verlangt blinde Beurteilungen dieses Versuchs. Sie haben Name oder Bewertung gesehen: Ihre würde nicht zählen.</translation>
    </message>
    <message>
        <source>Names and scores are hidden here. Your rating is blind if you have not opened the attempt&apos;s name and score. Attempts that the curriculum needs ratings of come first.</source>
        <translation>Namen und Bewertungen sind hier verborgen. Ihre Beurteilung ist blind, wenn Sie Name und Bewertung des Versuchs nicht geöffnet haben. Versuche, deren Beurteilung das Curriculum braucht, stehen zuerst.</translation>
    </message>
    <message>
        <source>Include attempts that I have rated</source>
        <translation>Auch Versuche, die ich beurteilt habe</translation>
    </message>
    <message>
        <source>Needed</source>
        <translation>Gebraucht</translation>
    </message>
    <message>
        <source>Yours</source>
        <translation>Ihre</translation>
    </message>
    <message>
        <source>Rate this attempt</source>
        <translation>Diesen Versuch beurteilen</translation>
    </message>
    <message>
        <source>The curriculum needs ratings of this attempt.</source>
        <translation>Das Curriculum braucht Beurteilungen dieses Versuchs.</translation>
    </message>
    <message numerus="yes">
        <source>%n attempts</source>
        <translation>
            <numerusform>%n Versuch</numerusform>
            <numerusform>%n Versuche</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempts, %1 awaiting rating</source>
        <translation>
            <numerusform>%n Versuch, Beurteilung steht aus: %1</numerusform>
            <numerusform>%n Versuche, Beurteilung steht aus: %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::TraceImportCard</name>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>Read the file</source>
        <translation>Datei lesen</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Column in the file</source>
        <translation>Spalte in der Datei</translation>
    </message>
    <message>
        <source>Unit in the file</source>
        <translation>Einheit in der Datei</translation>
    </message>
    <message>
        <source>Format of the file</source>
        <translation>Format der Datei</translation>
    </message>
    <message>
        <source>File …</source>
        <translation>Datei …</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>Performed at</source>
        <translation>Durchgeführt am</translation>
    </message>
    <message>
        <source>Choose a person</source>
        <translation>Person wählen</translation>
    </message>
    <message>
        <source>Fulcrum (CSV)</source>
        <translation>Fulcrum (CSV)</translation>
    </message>
    <message>
        <source>Another mapping file …</source>
        <translation>Andere Zuordnungsdatei …</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Mapping file</source>
        <translation>Zuordnungsdatei</translation>
    </message>
    <message>
        <source>Mappings (*.json)</source>
        <translation>Zuordnungen (*.json)</translation>
    </message>
    <message>
        <source>Choose the file that was recorded.</source>
        <translation>Wählen Sie die aufgezeichnete Datei.</translation>
    </message>
    <message>
        <source>Reading …</source>
        <translation>Wird gelesen …</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>rate unknown</source>
        <translation>Abtastrate unbekannt</translation>
    </message>
    <message numerus="yes">
        <source>%n samples</source>
        <translation>
            <numerusform>%n Messpunkt</numerusform>
            <numerusform>%n Messpunkte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n metrics have a value</source>
        <translation>
            <numerusform>%n Kennzahl hat einen Wert</numerusform>
            <numerusform>%n Kennzahlen haben einen Wert</numerusform>
        </translation>
    </message>
    <message>
        <source>Not read: %1.</source>
        <translation>Nicht gelesen: %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n samples without a value were left out.</source>
        <translation>
            <numerusform>%n Messpunkt ohne Wert wurde ausgelassen.</numerusform>
            <numerusform>%n Messpunkte ohne Wert wurden ausgelassen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stretches of more than 0.1 s have no sample; nothing is measured across them.</source>
        <translation>
            <numerusform>Ein Abschnitt von mehr als 0,1 s (Anzahl: %n) hat keinen Messpunkt; darüber hinweg wird nicht gemessen.</numerusform>
            <numerusform>%n Abschnitte von mehr als 0,1 s haben keinen Messpunkt; darüber hinweg wird nicht gemessen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose the person who performed it.</source>
        <translation>Wählen Sie die Person, die es durchgeführt hat.</translation>
    </message>
    <message>
        <source>Storing …</source>
        <translation>Wird gespeichert …</translation>
    </message>
    <message>
        <source>Give the time at which it was performed as 2026-11-20 14:05.</source>
        <translation>Geben Sie den Zeitpunkt der Durchführung als 2026-11-20 14:05 an.</translation>
    </message>
    <message>
        <source>Import a recording from another system</source>
        <translation>Aufzeichnung aus einem anderen System importieren</translation>
    </message>
    <message>
        <source>A recording from a box trainer, a robot or another simulator. It is measured and marked as external. It is not compared with limits and does not count in the curriculum.</source>
        <translation>Eine Aufzeichnung eines Boxtrainers, eines Roboters oder eines anderen Simulators. Sie wird gemessen und als extern gekennzeichnet. Sie wird nicht mit Grenzwerten verglichen und zählt nicht im Curriculum.</translation>
    </message>
    <message>
        <source>File of the recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>Recordings (*.csv *.txt *.tsv *.xml)</source>
        <translation>Aufzeichnungen (*.csv *.txt *.tsv *.xml)</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::TracePanel</name>
    <message>
        <source>left hand</source>
        <translation>linke Hand</translation>
    </message>
    <message>
        <source>right hand</source>
        <translation>rechte Hand</translation>
    </message>
    <message>
        <source>force (N)</source>
        <translation>Kraft (N)</translation>
    </message>
    <message>
        <source>speed (mm/s)</source>
        <translation>Geschwindigkeit (mm/s)</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Was geschah</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>limit, %1</source>
        <translation>Grenze, %1</translation>
    </message>
    <message>
        <source>Penalties only</source>
        <translation>Nur Fehler</translation>
    </message>
    <message>
        <source>force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Scroll to zoom, drag to move, click to jump to a moment, double-click to show everything; hold Shift and drag to choose a part.</source>
        <translation>Rollen vergrößert, Ziehen verschiebt, ein Klick springt zu einem Zeitpunkt, ein Doppelklick zeigt alles; mit gedrückter Umschalttaste ziehen wählt einen Abschnitt.</translation>
    </message>
    <message>
        <source>traction (N/m)</source>
        <translation>Zug (N/m)</translation>
    </message>
    <message>
        <source>tension (N)</source>
        <translation>Spannung (N)</translation>
    </message>
    <message>
        <source>traction across the cut (N/m)</source>
        <translation>Zug quer zum Schnitt (N/m)</translation>
    </message>
    <message>
        <source>tension of a band as it was divided (N)</source>
        <translation>Spannung eines Strangs, als er durchtrennt wurde (N)</translation>
    </message>
    <message>
        <source>traction, at least</source>
        <translation>Zug, mindestens</translation>
    </message>
    <message>
        <source>traction, at most</source>
        <translation>Zug, höchstens</translation>
    </message>
    <message>
        <source>energy; heat (mm²)</source>
        <translation>Energie; Hitze (mm²)</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>energy of each hand; tissue reached by heat that was not meant for it (mm²)</source>
        <translation>Energie jeder Hand; Gewebe, das Hitze erreicht hat, obwohl es nicht gemeint war (mm²)</translation>
    </message>
    <message>
        <source>energy of each hand</source>
        <translation>Energie jeder Hand</translation>
    </message>
    <message>
        <source>tissue reached by heat</source>
        <translation>Gewebe, das Hitze erreicht hat</translation>
    </message>
    <message>
        <source>Force, speed, traction and energy</source>
        <translation>Kraft, Geschwindigkeit, Zug und Energie</translation>
    </message>
    <message>
        <source>traction across the cut</source>
        <translation>Zug quer zum Schnitt</translation>
    </message>
    <message>
        <source>tension of a band</source>
        <translation>Spannung eines Bandes</translation>
    </message>
    <message>
        <source>energy, left hand</source>
        <translation>Energie, linke Hand</translation>
    </message>
    <message>
        <source>energy, right hand</source>
        <translation>Energie, rechte Hand</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::WorkspaceFit</name>
    <message>
        <source>Reach</source>
        <translation>Reichweite</translation>
    </message>
    <message>
        <source>The frame is where the device can be moved, the dashed box what the task needs of it. Hold the handle at the ring when an attempt begins. Seen from the side you are on the right.</source>
        <translation>Der Rahmen ist, wo sich das Gerät bewegen lässt, der gestrichelte Kasten, was die Aufgabe davon braucht. Halten Sie den Griff am Ring, wenn ein Versuch beginnt. In der Ansicht von der Seite sind Sie rechts.</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Fit the movement to the task</source>
        <translation>Bewegung an die Aufgabe anpassen</translation>
    </message>
    <message>
        <source>Left hand</source>
        <translation>Linke Hand</translation>
    </message>
    <message>
        <source>Right hand</source>
        <translation>Rechte Hand</translation>
    </message>
    <message>
        <source>%1: workspace %2 × %3 × %4 mm (across, up, deep).</source>
        <translation>%1: Arbeitsraum %2 × %3 × %4 mm (quer, hoch, tief).</translation>
    </message>
    <message>
        <source>This task has nothing for this hand.</source>
        <translation>Diese Aufgabe hat nichts für diese Hand.</translation>
    </message>
    <message>
        <source>All of the scene is reached from the ring.</source>
        <translation>Vom Ring aus wird die ganze Szene erreicht.</translation>
    </message>
    <message>
        <source>%1 % of the scene is reached from the ring.</source>
        <translation>Vom Ring aus werden %1 % der Szene erreicht.</translation>
    </message>
    <message>
        <source>The handle is at the ring.</source>
        <translation>Der Griff ist am Ring.</translation>
    </message>
    <message>
        <source>An attempt begins when the handle is at the ring</source>
        <translation>Ein Versuch beginnt, wenn der Griff am Ring ist</translation>
    </message>
    <message>
        <source>From where the handle is now: %1 %. The ring is %2.</source>
        <translation>Von dort, wo der Griff jetzt ist: %1 %. Der Ring liegt %2.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::WorkspaceView</name>
    <message>
        <source>%1: workspace from above and from the side</source>
        <translation>%1: Arbeitsraum von oben und von der Seite</translation>
    </message>
    <message>
        <source>from above</source>
        <translation>von oben</translation>
    </message>
    <message>
        <source>from the side</source>
        <translation>von der Seite</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::audit</name>
    <message>
        <source>File accepted for assessed attempts</source>
        <translation>Datei für bewertete Versuche zugelassen</translation>
    </message>
    <message>
        <source>Attempt begun</source>
        <translation>Versuch begonnen</translation>
    </message>
    <message>
        <source>Attempt finished</source>
        <translation>Versuch beendet</translation>
    </message>
    <message>
        <source>Attempt interrupted</source>
        <translation>Versuch unterbrochen</translation>
    </message>
    <message>
        <source>Attempt became practice</source>
        <translation>Versuch wurde zur Übung</translation>
    </message>
    <message>
        <source>External attempt imported</source>
        <translation>Externer Versuch importiert</translation>
    </message>
    <message>
        <source>Attempt reassigned</source>
        <translation>Versuch neu zugeordnet</translation>
    </message>
    <message>
        <source>Correction requested</source>
        <translation>Korrektur beantragt</translation>
    </message>
    <message>
        <source>Attempt voided</source>
        <translation>Versuch für ungültig erklärt</translation>
    </message>
    <message>
        <source>Cohort created</source>
        <translation>Gruppe angelegt</translation>
    </message>
    <message>
        <source>Cohort renamed</source>
        <translation>Gruppe umbenannt</translation>
    </message>
    <message>
        <source>Educators of a cohort set</source>
        <translation>Ausbilder einer Gruppe festgelegt</translation>
    </message>
    <message>
        <source>Members of a cohort set</source>
        <translation>Mitglieder einer Gruppe festgelegt</translation>
    </message>
    <message>
        <source>Comment sent</source>
        <translation>Kommentar gesendet</translation>
    </message>
    <message>
        <source>Moved to another version of the curriculum</source>
        <translation>Zu einer anderen Version des Curriculums gewechselt</translation>
    </message>
    <message>
        <source>Demonstration closed</source>
        <translation>Vorführung geschlossen</translation>
    </message>
    <message>
        <source>Contents of audit rows erased</source>
        <translation>Inhalte von Protokollzeilen gelöscht</translation>
    </message>
    <message>
        <source>Password changed</source>
        <translation>Passwort geändert</translation>
    </message>
    <message>
        <source>One-time password issued</source>
        <translation>Einmalpasswort ausgegeben</translation>
    </message>
    <message>
        <source>Password recovered</source>
        <translation>Passwort wiederhergestellt</translation>
    </message>
    <message>
        <source>Person added</source>
        <translation>Person hinzugefügt</translation>
    </message>
    <message>
        <source>Synthetic person added</source>
        <translation>Synthetische Person hinzugefügt</translation>
    </message>
    <message>
        <source>Login of a simulated person changed</source>
        <translation>Anmeldename einer simulierten Person geändert</translation>
    </message>
    <message>
        <source>Person renamed</source>
        <translation>Person umbenannt</translation>
    </message>
    <message>
        <source>Account activated or deactivated</source>
        <translation>Konto aktiviert oder deaktiviert</translation>
    </message>
    <message>
        <source>Roles changed</source>
        <translation>Rollen geändert</translation>
    </message>
    <message>
        <source>Programme created</source>
        <translation>Programm angelegt</translation>
    </message>
    <message>
        <source>Score added</source>
        <translation>Bewertung hinzugefügt</translation>
    </message>
    <message>
        <source>Sign-in list shown or hidden</source>
        <translation>Anmeldeliste ein- oder ausgeblendet</translation>
    </message>
    <message>
        <source>Signed in</source>
        <translation>Angemeldet</translation>
    </message>
    <message>
        <source>Standing decided by an educator</source>
        <translation>Stand von einem Ausbilder festgelegt</translation>
    </message>
    <message>
        <source>Records entered in the audit log</source>
        <translation>Datensätze ins Protokoll eingetragen</translation>
    </message>
    <message>
        <source>Store backed up</source>
        <translation>Datenbestand gesichert</translation>
    </message>
    <message>
        <source>Store restored from a backup</source>
        <translation>Datenbestand aus einer Sicherung wiederhergestellt</translation>
    </message>
    <message>
        <source>Store created</source>
        <translation>Datenbestand angelegt</translation>
    </message>
    <message>
        <source>First exchange with the programme server begun</source>
        <translation>Ersten Abgleich mit dem Programmserver begonnen</translation>
    </message>
    <message>
        <source>Synchronised with the programme server</source>
        <translation>Mit dem Programmserver abgeglichen</translation>
    </message>
    <message>
        <source>Received from the programme server</source>
        <translation>Vom Programmserver empfangen</translation>
    </message>
    <message>
        <source>Programme server: all</source>
        <translation>Programmserver: alle</translation>
    </message>
    <message>
        <source>Tissue values set</source>
        <translation>Gewebewerte festgelegt</translation>
    </message>
    <message>
        <source>Accepted files: all</source>
        <translation>Zugelassene Dateien: alle</translation>
    </message>
    <message>
        <source>Attempts: all</source>
        <translation>Versuche: alle</translation>
    </message>
    <message>
        <source>Cohorts: all</source>
        <translation>Gruppen: alle</translation>
    </message>
    <message>
        <source>Comments: all</source>
        <translation>Kommentare: alle</translation>
    </message>
    <message>
        <source>Versions of the curriculum: all</source>
        <translation>Versionen des Curriculums: alle</translation>
    </message>
    <message>
        <source>Demonstration: all</source>
        <translation>Vorführung: alle</translation>
    </message>
    <message>
        <source>Passwords: all</source>
        <translation>Passwörter: alle</translation>
    </message>
    <message>
        <source>Erased contents: all</source>
        <translation>Gelöschte Inhalte: alle</translation>
    </message>
    <message>
        <source>People: all</source>
        <translation>Personen: alle</translation>
    </message>
    <message>
        <source>Programme: all</source>
        <translation>Programm: alle</translation>
    </message>
    <message>
        <source>Scores: all</source>
        <translation>Bewertungen: alle</translation>
    </message>
    <message>
        <source>Settings: all</source>
        <translation>Einstellungen: alle</translation>
    </message>
    <message>
        <source>Standings: all</source>
        <translation>Stände: alle</translation>
    </message>
    <message>
        <source>Store: all</source>
        <translation>Datenbestand: alle</translation>
    </message>
    <message>
        <source>Tissue values: all</source>
        <translation>Gewebewerte: alle</translation>
    </message>
    <message>
        <source>Rating handed in</source>
        <translation>Beurteilung abgegeben</translation>
    </message>
    <message>
        <source>Rating shown to the trainee</source>
        <translation>Beurteilung für Lernende freigegeben</translation>
    </message>
    <message>
        <source>Ratings: all</source>
        <translation>Beurteilungen: alle</translation>
    </message>
    <message>
        <source>Personal goal dropped or changed</source>
        <translation>Persönliches Ziel aufgegeben oder geändert</translation>
    </message>
    <message>
        <source>Personal goal set</source>
        <translation>Persönliches Ziel gesetzt</translation>
    </message>
    <message>
        <source>Personal goals: all</source>
        <translation>Persönliche Ziele: alle</translation>
    </message>
    <message>
        <source>Person merged into another account</source>
        <translation>Person mit anderem Konto zusammengeführt</translation>
    </message>
    <message>
        <source>Merge of a person undone</source>
        <translation>Zusammenführen einer Person rückgängig gemacht</translation>
    </message>
    <message>
        <source>Exported for research</source>
        <translation>Für die Forschung exportiert</translation>
    </message>
    <message>
        <source>Report scheduled</source>
        <translation>Bericht geplant</translation>
    </message>
    <message>
        <source>Scheduled report not written</source>
        <translation>Geplanter Bericht nicht geschrieben</translation>
    </message>
    <message>
        <source>Schedule of a report ended</source>
        <translation>Planung eines Berichts beendet</translation>
    </message>
    <message>
        <source>Scheduled report written</source>
        <translation>Geplanter Bericht geschrieben</translation>
    </message>
    <message>
        <source>Scheduled reports: all</source>
        <translation>Geplante Berichte: alle</translation>
    </message>
    <message>
        <source>First row signed by the new key</source>
        <translation>Erste Zeile mit dem neuen Schlüssel</translation>
    </message>
    <message>
        <source>New key of the station announced</source>
        <translation>Neuer Schlüssel des Arbeitsplatzes angekündigt</translation>
    </message>
    <message>
        <source>Keys of the station: all</source>
        <translation>Schlüssel des Arbeitsplatzes: alle</translation>
    </message>
    <message>
        <source>Enrolled at the programme server</source>
        <translation>Auf dem Programmserver aufgenommen</translation>
    </message>
    <message>
        <source>Station: all</source>
        <translation>Station: alle</translation>
    </message>
    <message>
        <source>Error confirmed or struck</source>
        <translation>Fehler bestätigt oder gestrichen</translation>
    </message>
    <message>
        <source>Reviews of errors: all</source>
        <translation>Durchsicht von Fehlern: alle</translation>
    </message>
    <message>
        <source>All data of the person exported</source>
        <translation>Alle Daten der Person exportiert</translation>
    </message>
    <message>
        <source>Time for keeping data set</source>
        <translation>Aufbewahrungszeit festgelegt</translation>
    </message>
    <message>
        <source>Damaged store copied, unverified</source>
        <translation>Beschädigter Datenbestand kopiert, ungeprüft</translation>
    </message>
    <message>
        <source>Login changed</source>
        <translation>Anmeldename geändert</translation>
    </message>
    <message>
        <source>address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>administrator</source>
        <translation>Administrator</translation>
    </message>
    <message>
        <source>after</source>
        <translation>nachher</translation>
    </message>
    <message>
        <source>attempt</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>attempts</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>before</source>
        <translation>vorher</translation>
    </message>
    <message>
        <source>blinding</source>
        <translation>Verblindung</translation>
    </message>
    <message>
        <source>cause</source>
        <translation>Ursache</translation>
    </message>
    <message>
        <source>clock ahead (s)</source>
        <translation>Uhr geht vor (s)</translation>
    </message>
    <message>
        <source>cohort</source>
        <translation>Kohorte</translation>
    </message>
    <message>
        <source>cohorts</source>
        <translation>Kohorten</translation>
    </message>
    <message>
        <source>conflicts</source>
        <translation>Konflikte</translation>
    </message>
    <message>
        <source>copy</source>
        <translation>Kopie</translation>
    </message>
    <message>
        <source>number</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>demonstration</source>
        <translation>Demonstration</translation>
    </message>
    <message>
        <source>digest</source>
        <translation>Prüfsumme</translation>
    </message>
    <message>
        <source>erased</source>
        <translation>gelöscht</translation>
    </message>
    <message>
        <source>how often</source>
        <translation>wie oft</translation>
    </message>
    <message>
        <source>file</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>form</source>
        <translation>Bogen</translation>
    </message>
    <message>
        <source>format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>from</source>
        <translation>von</translation>
    </message>
    <message>
        <source>head of the chain</source>
        <translation>Kopf der Kette</translation>
    </message>
    <message>
        <source>into</source>
        <translation>in</translation>
    </message>
    <message>
        <source>key</source>
        <translation>Schlüssel</translation>
    </message>
    <message>
        <source>kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>last</source>
        <translation>zuletzt</translation>
    </message>
    <message>
        <source>login</source>
        <translation>Anmeldename</translation>
    </message>
    <message>
        <source>mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>new</source>
        <translation>neu</translation>
    </message>
    <message>
        <source>old</source>
        <translation>alt</translation>
    </message>
    <message>
        <source>people</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>person</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>problem</source>
        <translation>Problem</translation>
    </message>
    <message>
        <source>programme</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>received</source>
        <translation>empfangen</translation>
    </message>
    <message>
        <source>replaced</source>
        <translation>ersetzt</translation>
    </message>
    <message>
        <source>role</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>roles</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>rows</source>
        <translation>Zeilen</translation>
    </message>
    <message>
        <source>message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>geschlossen</translation>
    </message>
    <message>
        <source>sent</source>
        <translation>gesendet</translation>
    </message>
    <message>
        <source>server</source>
        <translation>Server</translation>
    </message>
    <message>
        <source>SHA-256</source>
        <translation>SHA-256</translation>
    </message>
    <message>
        <source>source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>state</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>hash of the state</source>
        <translation>Hash des Zustands</translation>
    </message>
    <message>
        <source>takes over</source>
        <translation>übernimmt</translation>
    </message>
    <message>
        <source>task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>to</source>
        <translation>nach</translation>
    </message>
    <message>
        <source>token</source>
        <translation>Token</translation>
    </message>
    <message>
        <source>what</source>
        <translation>was</translation>
    </message>
    <message>
        <source>verifier</source>
        <translation>Prüfwert</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>payload erased</source>
        <translation>Inhalt gelöscht</translation>
    </message>
    <message>
        <source>withheld</source>
        <translation>wird hier nicht gezeigt</translation>
    </message>
    <message>
        <source>unreadable</source>
        <translation>nicht lesbar</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::certificate</name>
    <message>
        <source>%1: proficient since %2, by decision of an educator</source>
        <translation>%1: sicher beherrscht seit %2, durch Entscheidung eines Ausbilders</translation>
    </message>
    <message>
        <source>%1: proficient since %2</source>
        <translation>%1: sicher beherrscht seit %2</translation>
    </message>
    <message>
        <source>Certificate of %1</source>
        <translation>Zertifikat von %1</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Zertifikat</translation>
    </message>
    <message>
        <source>has completed stage %1, %2, of the curriculum %3 on %4.</source>
        <translation>hat die Stufe %1, %2, des Curriculums %3 am %4 abgeschlossen.</translation>
    </message>
    <message>
        <source>Proficiency is declared by the rule of the curriculum (%1) or by an educator; limits from synthetic operators never declare it. It is checked again after 14, 30, 91 and 182 days.</source>
        <translation>„Sicher beherrscht“ wird nach der Regel des Curriculums (%1) oder durch einen Ausbilder festgestellt, nie mit Grenzwerten von simulierten Operateuren. Nach 14, 30, 91 und 182 Tagen wird es erneut geprüft.</translation>
    </message>
    <message>
        <source>Director of the programme</source>
        <translation>Programmleitung</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Check code %1</source>
        <translation>Prüfcode %1</translation>
    </message>
    <message>
        <source>The programme verifies it with: fulcrum certificate --verify %1 --as LOGIN. The code is valid while every proficiency above is in force.</source>
        <translation>Das Programm prüft ihn mit: fulcrum certificate --verify %1 --as ANMELDENAME. Der Code ist gültig, solange alles oben Genannte sicher beherrscht wird.</translation>
    </message>
    <message>
        <source>person %1</source>
        <translation>Person %1</translation>
    </message>
    <message>
        <source>%1: proficient since %2, by the rule of %3</source>
        <translation>%1: sicher beherrscht seit %2, nach der Regel von %3</translation>
    </message>
    <message>
        <source>Completed under %1, before the move to %2.</source>
        <translation>Abgeschlossen unter %1, vor der Umstellung auf %2.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::concerns</name>
    <message>
        <source>%1: proficiency was lost; latest attempt on %2.</source>
        <translation>%1: nicht mehr sicher beherrscht; letzter Versuch am %2.</translation>
    </message>
    <message>
        <source>%1: a retention check was due on %2.</source>
        <translation>%1: Eine Erhaltungskontrolle war am %2 fällig.</translation>
    </message>
    <message>
        <source>%1: proficiency was lost; latest attempt on %2, by limits that are provisional and cannot restore it: build the benchmark set, or decide.</source>
        <translation>%1: nicht mehr sicher beherrscht; letzter Versuch am %2, nach vorläufigen Grenzwerten, die das nicht ändern können: Erstellen Sie den Richtwertsatz, oder entscheiden Sie.</translation>
    </message>
    <message>
        <source>%1: a retention check was due on %2. The limits are provisional and cannot complete it: build the benchmark set, or decide.</source>
        <translation>%1: Eine Erhaltungskontrolle war am %2 fällig. Die Grenzwerte sind vorläufig und können sie nicht abschließen: Erstellen Sie den Richtwertsatz, oder entscheiden Sie.</translation>
    </message>
    <message>
        <source>%1: ratings of the attempt of %2 are missing. Where nobody is left to rate it, the next attempt that meets the rule is rated, or decide.</source>
        <translation>%1: Beurteilungen des Versuchs vom %2 fehlen. Kann ihn niemand mehr beurteilen, wird der nächste Versuch beurteilt, mit dem die Regel erfüllt ist, oder entscheiden Sie.</translation>
    </message>
    <message>
        <source>%1: after %n attempts the curve levels off at %2 points (95 % interval %3 to %4), below the pass mark of %5.</source>
        <translation>%1: Nach %n Versuchen erreicht die Kurve ein Plateau bei %2 Punkten (95-%-Intervall %3 bis %4), unter der Bestehensgrenze von %5.</translation>
    </message>
    <message>
        <source>%1: %n attempts without proficiency.</source>
        <translation>%1: %n Versuche, noch nicht sicher beherrscht.</translation>
    </message>
    <message>
        <source>No practice for %n days, since %1, and tasks remain.</source>
        <translation>Keine Übung seit %n Tagen, seit %1, und es sind noch Aufgaben offen.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::errors</name>
    <message>
        <source>see who signed in here</source>
        <translation>sehen, wer sich hier angemeldet hat</translation>
    </message>
    <message>
        <source>see the list of people</source>
        <translation>die Personenliste ansehen</translation>
    </message>
    <message>
        <source>add or change people</source>
        <translation>Personen hinzufügen oder ändern</translation>
    </message>
    <message>
        <source>change roles</source>
        <translation>Rollen ändern</translation>
    </message>
    <message>
        <source>issue a one-time password</source>
        <translation>ein Einmalpasswort ausgeben</translation>
    </message>
    <message>
        <source>change this password</source>
        <translation>dieses Passwort ändern</translation>
    </message>
    <message>
        <source>create synthetic people</source>
        <translation>synthetische Personen anlegen</translation>
    </message>
    <message>
        <source>see the cohorts</source>
        <translation>die Gruppen ansehen</translation>
    </message>
    <message>
        <source>change cohorts</source>
        <translation>Gruppen ändern</translation>
    </message>
    <message>
        <source>perform an attempt</source>
        <translation>einen Versuch durchführen</translation>
    </message>
    <message>
        <source>open this attempt</source>
        <translation>diesen Versuch öffnen</translation>
    </message>
    <message>
        <source>read the recording of this attempt</source>
        <translation>die Aufzeichnung dieses Versuchs lesen</translation>
    </message>
    <message>
        <source>see this person&apos;s progress</source>
        <translation>den Fortschritt dieser Person ansehen</translation>
    </message>
    <message>
        <source>see this cohort</source>
        <translation>diese Gruppe ansehen</translation>
    </message>
    <message>
        <source>score interrupted attempts</source>
        <translation>unterbrochene Versuche bewerten</translation>
    </message>
    <message>
        <source>recompute scores</source>
        <translation>Bewertungen neu berechnen</translation>
    </message>
    <message>
        <source>comment on this attempt</source>
        <translation>diesen Versuch kommentieren</translation>
    </message>
    <message>
        <source>read the comments on this attempt</source>
        <translation>die Kommentare zu diesem Versuch lesen</translation>
    </message>
    <message>
        <source>mark comments as read</source>
        <translation>Kommentare als gelesen markieren</translation>
    </message>
    <message>
        <source>decide on someone&apos;s standing</source>
        <translation>den Stand einer Person festlegen</translation>
    </message>
    <message>
        <source>accept files for assessed attempts</source>
        <translation>Dateien für bewertete Versuche zulassen</translation>
    </message>
    <message>
        <source>void this attempt</source>
        <translation>diesen Versuch für ungültig erklären</translation>
    </message>
    <message>
        <source>reassign this attempt</source>
        <translation>diesen Versuch neu zuordnen</translation>
    </message>
    <message>
        <source>ask for a correction of this attempt</source>
        <translation>eine Korrektur dieses Versuchs beantragen</translation>
    </message>
    <message>
        <source>read requests for corrections</source>
        <translation>Korrekturanträge lesen</translation>
    </message>
    <message>
        <source>export this person&apos;s data</source>
        <translation>die Daten dieser Person exportieren</translation>
    </message>
    <message>
        <source>export this cohort&apos;s data</source>
        <translation>die Daten dieser Gruppe exportieren</translation>
    </message>
    <message>
        <source>read the audit log</source>
        <translation>das Protokoll lesen</translation>
    </message>
    <message>
        <source>check the store</source>
        <translation>den Datenbestand prüfen</translation>
    </message>
    <message>
        <source>back up the store</source>
        <translation>den Datenbestand sichern</translation>
    </message>
    <message>
        <source>change settings</source>
        <translation>Einstellungen ändern</translation>
    </message>
    <message>
        <source>see the tissue values</source>
        <translation>die Gewebewerte ansehen</translation>
    </message>
    <message>
        <source>change the tissue values</source>
        <translation>die Gewebewerte ändern</translation>
    </message>
    <message>
        <source>act in this role</source>
        <translation>in dieser Rolle handeln</translation>
    </message>
    <message>
        <source>use this demonstration account</source>
        <translation>dieses Vorführkonto verwenden</translation>
    </message>
    <message>
        <source>close the demonstration programme</source>
        <translation>das Vorführprogramm schließen</translation>
    </message>
    <message>
        <source>build the demonstration</source>
        <translation>die Vorführung aufbauen</translation>
    </message>
    <message>
        <source>This role does not include it.</source>
        <translation>Diese Rolle umfasst das nicht.</translation>
    </message>
    <message>
        <source>The demonstration accepts practice attempts only.</source>
        <translation>In der Vorführung sind nur Übungen möglich.</translation>
    </message>
    <message>
        <source>The person is not in your care.</source>
        <translation>Die Person ist Ihnen nicht zugeordnet.</translation>
    </message>
    <message>
        <source>You may not do this to your own attempt.</source>
        <translation>Beim eigenen Versuch dürfen Sie das nicht.</translation>
    </message>
    <message>
        <source>You are signed in to another programme. Sign in again.</source>
        <translation>Sie sind bei einem anderen Programm angemeldet. Melden Sie sich neu an.</translation>
    </message>
    <message>
        <source>Demonstration accounts exist in the demonstration only.</source>
        <translation>Vorführkonten gibt es nur in der Vorführung.</translation>
    </message>
    <message>
        <source>This is possible in the demonstration only.</source>
        <translation>Das ist nur in der Vorführung möglich.</translation>
    </message>
    <message>
        <source>The account is no longer active.</source>
        <translation>Das Konto ist nicht mehr aktiv.</translation>
    </message>
    <message>
        <source>The role was withdrawn. Sign in again.</source>
        <translation>Die Rolle wurde entzogen. Melden Sie sich neu an.</translation>
    </message>
    <message>
        <source>Change the one-time password first.</source>
        <translation>Ändern Sie zuerst das Einmalpasswort.</translation>
    </message>
    <message>
        <source>You do not hold the role %1.</source>
        <translation>Sie haben die Rolle %1 nicht.</translation>
    </message>
    <message>
        <source>merge these accounts</source>
        <translation>diese Konten zusammenführen</translation>
    </message>
    <message>
        <source>You may not do this to an account of your own.</source>
        <translation>Beim eigenen Konto dürfen Sie das nicht.</translation>
    </message>
    <message>
        <source>It belongs to another account.</source>
        <translation>Es gehört zu einem anderen Konto.</translation>
    </message>
    <message>
        <source>The comment belongs to another person.</source>
        <translation>Der Kommentar gehört einer anderen Person.</translation>
    </message>
    <message>
        <source>You may not do this as %1.</source>
        <translation>Als %1 dürfen Sie das nicht.</translation>
    </message>
    <message>
        <source>You may not %1 as %2.</source>
        <translation>Als %2 dürfen Sie das nicht: %1.</translation>
    </message>
    <message>
        <source>rate this attempt</source>
        <translation>diesen Versuch beurteilen</translation>
    </message>
    <message>
        <source>see the ratings of this attempt</source>
        <translation>die Beurteilungen dieses Versuchs sehen</translation>
    </message>
    <message>
        <source>show the ratings of this attempt to the trainee</source>
        <translation>die Beurteilungen dieses Versuchs freigeben</translation>
    </message>
    <message>
        <source>The form belongs to another person.</source>
        <translation>Der Bogen gehört einer anderen Person.</translation>
    </message>
    <message>
        <source>Only the program does this, in the demonstration.</source>
        <translation>Das tut nur die Software, in der Vorführung.</translation>
    </message>
    <message>
        <source>set this goal</source>
        <translation>dieses Ziel setzen</translation>
    </message>
    <message>
        <source>see this person&apos;s goals</source>
        <translation>die Ziele dieser Person sehen</translation>
    </message>
    <message>
        <source>The programme server is only read here. Do it at a station.</source>
        <translation>Der Programmserver wird hier nur gelesen. Tun Sie es an einer Station.</translation>
    </message>
    <message>
        <source>import a trace for this person</source>
        <translation>eine Aufzeichnung für diese Person importieren</translation>
    </message>
    <message>
        <source>change the station&apos;s key</source>
        <translation>den Schlüssel des Arbeitsplatzes wechseln</translation>
    </message>
    <message>
        <source>erase this person</source>
        <translation>diese Person löschen</translation>
    </message>
    <message>
        <source>confirm or strike this error</source>
        <translation>diesen Fehler bestätigen oder streichen</translation>
    </message>
    <message>
        <source>export all that is stored about this person</source>
        <translation>alles exportieren, was über diese Person gespeichert ist</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::goals</name>
    <message>
        <source>Today is the last day.</source>
        <translation>Heute ist der letzte Tag.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>d MMM yyyy</source>
        <translation>d. MMM yyyy</translation>
    </message>
    <message>
        <source>%1: %2 at least %3 by %4</source>
        <translation>%1: %2 mindestens %3 bis %4</translation>
    </message>
    <message>
        <source>%1: %2 at most %3 by %4</source>
        <translation>%1: %2 höchstens %3 bis %4</translation>
    </message>
    <message>
        <source>%1 of %2 this week.</source>
        <translation>%1 von %2 in dieser Woche.</translation>
    </message>
    <message>
        <source>Reached.</source>
        <translation>Erreicht.</translation>
    </message>
    <message>
        <source>Reached: %1.</source>
        <translation>Erreicht: %1.</translation>
    </message>
    <message>
        <source>Best so far %1, before %2.</source>
        <translation>Bisher bester Wert %1, vorher %2.</translation>
    </message>
    <message>
        <source>Best so far %1.</source>
        <translation>Bisher bester Wert %1.</translation>
    </message>
    <message>
        <source>No completed attempt since then.</source>
        <translation>Seitdem kein abgeschlossener Versuch.</translation>
    </message>
    <message>
        <source>The day has passed.</source>
        <translation>Der Tag ist vorbei.</translation>
    </message>
    <message>
        <source>%1 % of the goal</source>
        <translation>%1 % des Ziels</translation>
    </message>
    <message numerus="yes">
        <source>%n days left.</source>
        <translation>
            <numerusform>Noch %n Tag.</numerusform>
            <numerusform>Noch %n Tage.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempts a week</source>
        <translation>
            <numerusform>%n Versuch pro Woche</numerusform>
            <numerusform>%n Versuche pro Woche</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::learning_curve</name>
    <message>
        <source>The curve has not levelled off yet.</source>
        <translation>Die Kurve hat noch kein Plateau erreicht.</translation>
    </message>
    <message>
        <source>The curve levels off at %1 (95 % interval %2 to %3).</source>
        <translation>Die Kurve erreicht ein Plateau bei %1 (95-%-Intervall %2 bis %3).</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1 or later, or never</source>
        <translation>%1 oder später, oder nie</translation>
    </message>
    <message>
        <source>It would meet the limit of %1 at attempt %2 (%3).</source>
        <translation>Sie würde den Grenzwert %1 bei Versuch %2 erfüllen (%3).</translation>
    </message>
    <message>
        <source>A learning curve is shown from %1 completed attempts on.</source>
        <translation>Eine Lernkurve wird ab %1 abgeschlossenen Versuchen gezeigt.</translation>
    </message>
    <message>
        <source>At this level it does not meet the limit of %1. Discuss with your educator what to change.</source>
        <translation>Damit erfüllt sie den Grenzwert %1 nicht. Besprechen Sie mit Ihrem Ausbilder, was Sie ändern sollten.</translation>
    </message>
    <message>
        <source>Since attempt %2 it no longer meets the limit of %1.</source>
        <translation>Seit Versuch %2 erfüllt sie den Grenzwert %1 nicht mehr.</translation>
    </message>
    <message>
        <source>It has met the limit of %1 since attempt %2.</source>
        <translation>Sie erfüllt den Grenzwert %1 seit Versuch %2.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::next_task</name>
    <message>
        <source>today</source>
        <translation>heute</translation>
    </message>
    <message>
        <source>yesterday</source>
        <translation>gestern</translation>
    </message>
    <message>
        <source>%n days ago</source>
        <translation>vor %n Tagen</translation>
    </message>
    <message>
        <source>No task of the curriculum is unlocked.</source>
        <translation>Keine Aufgabe des Curriculums ist freigegeben.</translation>
    </message>
    <message>
        <source>You have not tried this task of the stage %1 yet.</source>
        <translation>Diese Aufgabe der Stufe %1 haben Sie noch nicht versucht.</translation>
    </message>
    <message>
        <source>Your curve in %1 levels off below the pass mark, and %2 is %3 (median of your latest attempts: %4): %5.</source>
        <translation>Ihre Kurve in %1 erreicht ein Plateau unter der Bestehensgrenze, und %2 liegt %3 (Median Ihrer letzten Versuche: %4): %5.</translation>
    </message>
    <message>
        <source>You are proficient in this task. A retention check has been due since %1.</source>
        <translation>Sie beherrschen diese Aufgabe sicher. Eine Kontrolle ist seit %1 fällig.</translation>
    </message>
    <message>
        <source>Your results have fallen below proficiency. Three passes in four attempts restore it.</source>
        <translation>Ihre Ergebnisse reichen nicht mehr für „sicher beherrscht“. Drei bestandene von vier Versuchen stellen es wieder her.</translation>
    </message>
    <message>
        <source>Of the tasks left in the stage %1, you practised this one least recently (%2).</source>
        <translation>Von den übrigen Aufgaben der Stufe %1 haben Sie diese am längsten nicht geübt (%2).</translation>
    </message>
    <message>
        <source>A retention check of this task has been due since %1. It cannot be taken with %2, but with: %3. Until then you can practise it.</source>
        <translation>Eine Kontrolle dieser Aufgabe ist seit %1 fällig. Mit %2 ist sie nicht möglich, aber mit: %3. Bis dahin können Sie die Aufgabe üben.</translation>
    </message>
    <message>
        <source>A retention check of this task has been due since %1. The limits for %2 are provisional and cannot complete it; passes with these count: %3. Until then you can practise it.</source>
        <translation>Eine Kontrolle dieser Aufgabe ist seit %1 fällig. Die Grenzwerte für %2 sind vorläufig und können sie nicht abschließen; es zählen bestandene Versuche mit: %3. Bis dahin können Sie die Aufgabe üben.</translation>
    </message>
    <message>
        <source>Your results in this task have fallen below proficiency, which cannot be restored with %1, but with: %2. Until then you can practise it.</source>
        <translation>Ihre Ergebnisse in dieser Aufgabe reichen nicht mehr für „sicher beherrscht“. Mit %1 lässt es sich nicht wiederherstellen, aber mit: %2. Bis dahin können Sie die Aufgabe üben.</translation>
    </message>
    <message>
        <source>Your results in this task have fallen below proficiency. The limits for %1 are provisional and cannot restore it; passes with these count: %2. Until then you can practise it.</source>
        <translation>Ihre Ergebnisse in dieser Aufgabe reichen nicht mehr für „sicher beherrscht“. Die Grenzwerte für %1 sind vorläufig und können es nicht wiederherstellen; es zählen bestandene Versuche mit: %2. Bis dahin können Sie die Aufgabe üben.</translation>
    </message>
    <message>
        <source>The remaining tasks cannot be assessed with %1, but you can practise this one.</source>
        <translation>Mit %1 können die übrigen Aufgaben nicht bewertet werden, aber diese können Sie üben.</translation>
    </message>
    <message>
        <source>Your results in this task have fallen below proficiency. Provisional limits cannot restore it; an educator can decide. Until then you can practise it.</source>
        <translation>Ihre Ergebnisse in dieser Aufgabe reichen nicht mehr für „sicher beherrscht“. Vorläufige Grenzwerte können es nicht wiederherstellen; ein Ausbilder kann entscheiden. Bis dahin können Sie die Aufgabe üben.</translation>
    </message>
    <message>
        <source>A retention check of this task has been due since %1. Provisional limits cannot complete it; an educator can decide. Until then you can practise it.</source>
        <translation>Eine Kontrolle dieser Aufgabe ist seit %1 fällig. Vorläufige Grenzwerte können sie nicht abschließen; ein Ausbilder kann entscheiden. Bis dahin können Sie die Aufgabe üben.</translation>
    </message>
    <message>
        <source>Nobody can meet the rule of this task: ask your educator to correct the curriculum. Until then you can practise it.</source>
        <translation>Niemand kann die Regel dieser Aufgabe erfüllen: Bitten Sie Ihren Ausbilder, das Curriculum zu berichtigen. Bis dahin können Sie die Aufgabe üben.</translation>
    </message>
    <message>
        <source>The remaining tasks await ratings by your educators. Until then you can practise this one.</source>
        <translation>Für die übrigen Aufgaben fehlen Beurteilungen durch Ihre Ausbilder. Bis dahin können Sie diese üben.</translation>
    </message>
    <message>
        <source>You have completed every task. You performed this one least recently (%1).</source>
        <translation>Alle Aufgaben sind erledigt; bei dieser liegt Ihr letzter Versuch am längsten zurück (%1).</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::pages</name>
    <message>
        <source>Home</source>
        <translation>Startseite</translation>
    </message>
    <message>
        <source>My progress</source>
        <translation>Mein Fortschritt</translation>
    </message>
    <message>
        <source>My attempts</source>
        <translation>Meine Versuche</translation>
    </message>
    <message>
        <source>Cohorts</source>
        <translation>Gruppen</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Kennzahlen</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>Arbeitsplatz</translation>
    </message>
    <message>
        <source>Audit log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Assign cohorts</source>
        <translation>Gruppen zuteilen</translation>
    </message>
    <message>
        <source>Tissue</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>Curriculum</source>
        <translation>Curriculum</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Beurteilen</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenzwerte</translation>
    </message>
    <message>
        <source>Reports</source>
        <translation>Berichte</translation>
    </message>
    <message>
        <source>Personal data</source>
        <translation>Personendaten</translation>
    </message>
    <message>
        <source>Dashboard</source>
        <translation>Übersicht</translation>
    </message>
    <message>
        <source>Build limits</source>
        <translation>Grenzwerte bilden</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::ratings</name>
    <message>
        <source>poor</source>
        <translation>schlecht</translation>
    </message>
    <message>
        <source>moderate</source>
        <translation>mäßig</translation>
    </message>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>excellent</source>
        <translation>ausgezeichnet</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>not seen</source>
        <translation>nicht gesehen</translation>
    </message>
    <message>
        <source>blind</source>
        <translation>blind</translation>
    </message>
    <message>
        <source>not blind</source>
        <translation>nicht blind</translation>
    </message>
    <message>
        <source>The raters gave the same ratings.</source>
        <translation>Die Beurteilungen stimmen überein.</translation>
    </message>
    <message>
        <source>The raters differ most in &quot;%1&quot;: %2 to %3.</source>
        <translation>Die größte Abweichung liegt bei „%1“: %2 bis %3.</translation>
    </message>
    <message>
        <source>Agreement of raters with %1: not known yet. It takes two attempts that the same two people rated.</source>
        <translation>Übereinstimmung der Beurteilenden mit %1: noch nicht bekannt. Dazu braucht es zwei Versuche, die dieselben zwei Personen beurteilt haben.</translation>
    </message>
    <message>
        <source>Agreement of raters with %1: cannot be computed, because all their ratings are equal.</source>
        <translation>Übereinstimmung der Beurteilenden mit %1: nicht berechenbar, weil alle Beurteilungen gleich sind.</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Agreement of raters with %1: %2. ICC(2,1) %3, 95 % interval %4 to %5 (%6 raters, %7 attempts).</source>
        <translation>Übereinstimmung der Beurteilenden mit %1: %2. ICC(2,1) %3, 95-%-Intervall %4 bis %5 (Beurteilende: %6, Versuche: %7).</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::remedies</name>
    <message>
        <source>above %1</source>
        <translation>über %1</translation>
    </message>
    <message>
        <source>below %1</source>
        <translation>unter %1</translation>
    </message>
    <message>
        <source>practise it from the goal “%1” on</source>
        <translation>üben Sie ab dem Ziel „%1“</translation>
    </message>
    <message>
        <source>practise %1</source>
        <translation>üben Sie %1</translation>
    </message>
    <message>
        <source>practise %1 in the variant “%2”</source>
        <translation>üben Sie %1 in der Variante „%2“</translation>
    </message>
    <message>
        <source>practise it in the variant “%1”</source>
        <translation>üben Sie in der Variante „%1“</translation>
    </message>
    <message>
        <source>practise it with the ghost of an expert</source>
        <translation>üben Sie mit dem Schattenbild eines Experten</translation>
    </message>
    <message>
        <source>watch an expert do it</source>
        <translation>sehen Sie einem Experten zu</translation>
    </message>
    <message>
        <source>look at the replay of the latest attempt</source>
        <translation>sehen Sie sich die Wiedergabe des letzten Versuchs an</translation>
    </message>
    <message>
        <source>%1 %2: %3</source>
        <translation>%1 %2: %3</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::report_export</name>
    <message>
        <source>Saved %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>Writing the report …</source>
        <translation>Der Bericht wird geschrieben …</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::standing</name>
    <message>
        <source>not known here</source>
        <translation>hier nicht bekannt</translation>
    </message>
    <message>
        <source>%1 (decision)</source>
        <translation>%1 (Entscheidung)</translation>
    </message>
    <message>
        <source>%1, by decision of an educator</source>
        <translation>%1, durch Entscheidung eines Ausbilders</translation>
    </message>
    <message>
        <source>d MMM yyyy</source>
        <translation>d. MMM yyyy</translation>
    </message>
    <message>
        <source>passed (provisional)</source>
        <translation>bestanden (vorläufig)</translation>
    </message>
    <message>
        <source>check overdue</source>
        <translation>Kontrolle überfällig</translation>
    </message>
    <message>
        <source>locked until proficient in %1</source>
        <translation>gesperrt, bis sicher beherrscht: %1</translation>
    </message>
    <message>
        <source>open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>attempted, not passed yet</source>
        <translation>begonnen, noch nicht bestanden</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>proficient since %1</source>
        <translation>sicher beherrscht seit %1</translation>
    </message>
    <message>
        <source>proficient, last check passed</source>
        <translation>sicher beherrscht, letzte Kontrolle bestanden</translation>
    </message>
    <message>
        <source>check overdue since %1</source>
        <translation>Kontrolle überfällig seit %1</translation>
    </message>
    <message>
        <source>check due since %1</source>
        <translation>Kontrolle fällig seit %1</translation>
    </message>
    <message>
        <source>relapsed</source>
        <translation>zurückgefallen</translation>
    </message>
    <message>
        <source>Next check on %1.</source>
        <translation>Nächste Kontrolle am %1.</translation>
    </message>
    <message>
        <source>Nobody can meet the rule of this task: it counts too few attempts. Ask your educator to correct the curriculum.</source>
        <translation>Niemand kann die Regel dieser Aufgabe erfüllen: Sie zählt zu wenige Versuche. Bitten Sie Ihren Ausbilder, das Curriculum zu berichtigen.</translation>
    </message>
    <message>
        <source>Pass once more on another day.</source>
        <translation>Bestehen Sie noch einmal an einem anderen Tag.</translation>
    </message>
    <message>
        <source>Pass once on another variant of the task.</source>
        <translation>Bestehen Sie einmal mit einer anderen Variante der Aufgabe.</translation>
    </message>
    <message>
        <source>Pass on %n more variants of the task.</source>
        <translation>Bestehen Sie mit %n weiteren Varianten der Aufgabe.</translation>
    </message>
    <message>
        <source>%n attempts without proficiency: ask your educator.</source>
        <translation>%n Versuche, noch nicht sicher beherrscht: Fragen Sie Ihren Ausbilder.</translation>
    </message>
    <message>
        <source>passed, awaiting rating</source>
        <translation>bestanden, Beurteilung steht aus</translation>
    </message>
    <message>
        <source>Educators rate the attempt of %1: %2 of %3 ratings are released.</source>
        <translation>Ausbilder beurteilen den Versuch vom %1: %2 von %3 Beurteilungen sind freigegeben.</translation>
    </message>
    <message>
        <source>Ratings of the attempt of %1 are missing (%2 of %3 are released): the next pass that meets the rule is rated. An educator can decide.</source>
        <translation>Beurteilungen des Versuchs vom %1 fehlen (%2 von %3 sind freigegeben): Der nächste bestandene Versuch, mit dem die Regel erfüllt ist, wird beurteilt. Ein Ausbilder kann entscheiden.</translation>
    </message>
    <message>
        <source>The ratings of the attempt of %1 are below the limit: the next pass that meets the rule is rated.</source>
        <translation>Die Beurteilungen des Versuchs vom %1 liegen unter der Grenze: Der nächste bestandene Versuch, mit dem die Regel erfüllt ist, wird beurteilt.</translation>
    </message>
    <message>
        <source>Provisional limits, which judged your latest attempt, cannot complete the check. An educator can decide.</source>
        <translation>Mit vorläufigen Grenzwerten, nach denen Ihr letzter Versuch bewertet wurde, kann die Kontrolle nicht abgeschlossen werden. Ein Ausbilder kann entscheiden.</translation>
    </message>
    <message>
        <source>Provisional limits, which judged your latest attempt, cannot restore proficiency. An educator can decide.</source>
        <translation>Mit vorläufigen Grenzwerten, nach denen Ihr letzter Versuch bewertet wurde, kann „sicher beherrscht“ nicht wiederhergestellt werden. Ein Ausbilder kann entscheiden.</translation>
    </message>
    <message>
        <source>Pass twice on one day to complete the check.</source>
        <translation>Bestehen Sie zweimal an einem Tag, um die Kontrolle abzuschließen.</translation>
    </message>
    <message>
        <source>Pass twice on one day to complete the check. Provisional limits cannot complete it; passes with these count: %1.</source>
        <translation>Bestehen Sie zweimal an einem Tag, um die Kontrolle abzuschließen. Vorläufige Grenzwerte können sie nicht abschließen; es zählen bestandene Versuche mit: %1.</translation>
    </message>
    <message>
        <source>Three passes in four attempts restore proficiency.</source>
        <translation>Drei bestandene von vier Versuchen stellen „sicher beherrscht“ wieder her.</translation>
    </message>
    <message>
        <source>Three passes in four attempts restore proficiency. Provisional limits cannot restore it; passes with these count: %1.</source>
        <translation>Drei bestandene von vier Versuchen stellen „sicher beherrscht“ wieder her. Vorläufige Grenzwerte können es nicht wiederherstellen; es zählen bestandene Versuche mit: %1.</translation>
    </message>
    <message>
        <source>You have enough passes, but the limits are provisional: later tasks are unlocked, and proficiency is not declared.</source>
        <translation>Genug Versuche sind bestanden, aber die Grenzwerte sind vorläufig: Spätere Aufgaben sind freigegeben, „sicher beherrscht“ wird nicht festgestellt.</translation>
    </message>
    <message>
        <source>You have enough passes for the present rule: the next pass that meets it counts.</source>
        <translation>Für die jetzige Regel sind genug Versuche bestanden: Der nächste bestandene Versuch, mit dem sie erfüllt ist, zählt.</translation>
    </message>
    <message>
        <source>%1 % of the way to proficiency</source>
        <translation>%1 % des Weges bis „sicher beherrscht“</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::text</name>
    <message>
        <source>%1 (deactivated)</source>
        <translation>%1 (deaktiviert)</translation>
    </message>
    <message>
        <source>below −5</source>
        <translation>unter −5</translation>
    </message>
    <message>
        <source>above 5 (far outside)</source>
        <translation>über 5 (weit außerhalb)</translation>
    </message>
    <message>
        <source>%1 of 100 points</source>
        <translation>%1 von 100 Punkten</translation>
    </message>
    <message>
        <source>d MMM yyyy</source>
        <translation>d. MMM yyyy</translation>
    </message>
    <message>
        <source>d MMM yyyy HH:mm</source>
        <translation>d. MMM yyyy HH:mm</translation>
    </message>
    <message>
        <source>not scored</source>
        <translation>nicht bewertet</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>nicht bestanden</translation>
    </message>
    <message>
        <source>passed (provisional)</source>
        <translation>bestanden (vorläufig)</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>%1 (synthetic)</source>
        <translation>%1 (synthetisch)</translation>
    </message>
    <message>
        <source>left hand</source>
        <translation>linke Hand</translation>
    </message>
    <message>
        <source>right hand</source>
        <translation>rechte Hand</translation>
    </message>
    <message>
        <source>Force was felt at %1 % by the left hand and at %2 % by the right.</source>
        <translation>Die Kraft war mit der linken Hand zu %1 % und mit der rechten zu %2 % fühlbar.</translation>
    </message>
    <message>
        <source>Force was felt at %1 %.</source>
        <translation>Die Kraft war zu %1 % fühlbar.</translation>
    </message>
    <message>
        <source>Force was felt at %1 %, by the left hand only.</source>
        <translation>Die Kraft war zu %1 % fühlbar, nur mit der linken Hand.</translation>
    </message>
    <message>
        <source>Force was felt at %1 %, by the right hand only.</source>
        <translation>Die Kraft war zu %1 % fühlbar, nur mit der rechten Hand.</translation>
    </message>
    <message>
        <source>trainee</source>
        <translation>Lernende(r)</translation>
    </message>
    <message>
        <source>educator</source>
        <translation>Ausbilder</translation>
    </message>
    <message>
        <source>director</source>
        <translation>Programmleitung</translation>
    </message>
    <message>
        <source>administrator</source>
        <translation>Administrator</translation>
    </message>
    <message>
        <source>all %1 at version %2</source>
        <translation>alle %1 in Version %2</translation>
    </message>
    <message>
        <source>%1 at version %2; %3</source>
        <translation>%1 in Version %2; %3</translation>
    </message>
    <message>
        <source>%1 simulated experts, benchmark set %2</source>
        <translation>%1 simulierte Experten, Satz %2</translation>
    </message>
    <message>
        <source>%1; taken over with benchmark set %2 (%3)</source>
        <translation>%1; übernommen mit Satz %2 (%3)</translation>
    </message>
    <message>
        <source>%1 experts, benchmark set %2</source>
        <translation>%1 Experten, Satz %2</translation>
    </message>
    <message>
        <source>; the worst value that counts</source>
        <translation>; der schlechteste Wert, der zählt</translation>
    </message>
    <message>
        <source>%1 readings per second (%2 stated)</source>
        <translation>%1 Messungen pro Sekunde (angegeben: %2)</translation>
    </message>
    <message>
        <source>%1 readings per second</source>
        <translation>%1 Messungen pro Sekunde</translation>
    </message>
    <message>
        <source>%1 readings per second stated</source>
        <translation>%1 Messungen pro Sekunde angegeben</translation>
    </message>
    <message>
        <source>movement of the instrument %1 %</source>
        <translation>Bewegung des Instruments %1 %</translation>
    </message>
    <message>
        <source>left and right device swapped</source>
        <translation>linkes und rechtes Gerät vertauscht</translation>
    </message>
    <message>
        <source>Device: %1.</source>
        <translation>Gerät: %1.</translation>
    </message>
    <message>
        <source>Nothing has happened yet. To confirm, choose: %1</source>
        <translation>Noch ist nichts geschehen. Zur Bestätigung wählen: %1</translation>
    </message>
    <message>
        <source>station</source>
        <translation>Arbeitsplatz</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::themes</name>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
</context>
</TS>
