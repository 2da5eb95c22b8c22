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
    <name>fulcrum::app::demo</name>
    <message>
        <source>%1 performs %2</source>
        <translation>%1 führt %2 durch</translation>
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
        <source>3D Systems Touch</source>
        <translation>3D Systems Touch</translation>
    </message>
    <message>
        <source>Force Dimension, Novint Falcon</source>
        <translation>Force Dimension, Novint Falcon</translation>
    </message>
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
        <source>this version of Fulcrum cannot drive it</source>
        <translation>diese Version von Fulcrum kann es nicht ansteuern</translation>
    </message>
    <message>
        <source>use mouse and keyboard</source>
        <translation>verwenden Sie Maus und Tastatur</translation>
    </message>
    <message>
        <source>two mice and keyboard</source>
        <translation>zwei Mäuse und Tastatur</translation>
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
        <source>neither: context only</source>
        <translation>weder noch: nur zur Einordnung</translation>
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
        <source>pull until the plane opens and follow the middle of the stretched fibres</source>
        <translation>ziehen Sie, bis sich die Schicht öffnet, und folgen Sie der Mitte der gespannten Fasern</translation>
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
        <source>Share of the marked line that was divided with a blade. What tore is not divided.</source>
        <translation>Anteil der markierten Linie, der mit einer Klinge durchtrennt wurde. Was gerissen ist, gilt nicht als durchtrennt.</translation>
    </message>
    <message>
        <source>{value} of the line was divided, below the required {limit}</source>
        <translation>{value} der Linie wurden durchtrennt, unter dem geforderten Wert von {limit}</translation>
    </message>
    <message>
        <source>pull less, and go back along the line and divide the bridges that are left</source>
        <translation>ziehen Sie weniger, gehen Sie die Linie noch einmal ab und durchtrennen Sie die verbliebenen Brücken</translation>
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
        <source>clip or seal a vessel before it is divided, and pull less</source>
        <translation>clippen oder versiegeln Sie ein Gefäß, bevor es durchtrennt wird, und ziehen Sie weniger</translation>
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
        <source>approach slowly, and stop pulling when the tissue no longer gives</source>
        <translation>nähern Sie sich langsam, und ziehen Sie nicht weiter, wenn das Gewebe nicht mehr nachgibt</translation>
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
        <source>decide on one direction of pull and keep it</source>
        <translation>entscheiden Sie sich für eine Zugrichtung und behalten Sie sie bei</translation>
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
        <source>Jaw force integrated over one grasp, the largest of all grasps.</source>
        <translation>Maulkraft, über einen Griff integriert, das größte Ergebnis aller Griffe.</translation>
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
        <source>take a larger bite before pulling</source>
        <translation>fassen Sie mehr Gewebe, bevor Sie ziehen</translation>
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
        <source>place the jaws where the pull will be, then close once</source>
        <translation>setzen Sie das Maul dort an, wo Sie ziehen werden, und schließen Sie es dann einmal</translation>
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
        <source>Share of the time inside the body in which the tip stood still and touched nothing.</source>
        <translation>Anteil der Zeit im Körper, in der die Spitze stillstand und nichts berührte.</translation>
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
        <source>Share of the time inside the body in which the tip was outside the image.</source>
        <translation>Anteil der Zeit im Körper, in der die Spitze außerhalb des Bildes war.</translation>
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
        <source>All gates are met; repeat it to make it a habit.</source>
        <translation>Alle Kriterien sind erfüllt; wiederholen Sie es, bis es zur Gewohnheit wird.</translation>
    </message>
    <message>
        <source>All gates are met, most narrowly {metric}{of_hand} ({value}; the limit is {limit}); {remedy}.</source>
        <translation>Alle Kriterien sind erfüllt, am knappsten {metric}{of_hand} ({value}; der Grenzwert ist {limit}); {remedy}.</translation>
    </message>
    <message>
        <source>The time ran out before the last goal was reached; {remedy}.</source>
        <translation>Die Zeit lief ab, bevor der letzte Schritt erreicht war; {remedy}.</translation>
    </message>
    <message>
        <source>The attempt was abandoned before the last goal was reached; carry the next one through to its end.</source>
        <translation>Der Versuch wurde abgebrochen, bevor der letzte Schritt erreicht war; führen Sie den nächsten bis zum Ende durch.</translation>
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
        <source>reason, kept in the audit log</source>
        <translation>Grund, bleibt im Protokoll</translation>
    </message>
    <message>
        <source>what is wrong with this attempt</source>
        <translation>was an diesem Versuch nicht stimmt</translation>
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
        <source>Open the attempt</source>
        <translation>Versuch öffnen</translation>
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
        <source>Scores computed with older metrics or limits: %1. Recomputing adds a new score next to each; the score in force stays.</source>
        <translation>Bewertungen, die mit älteren Kennzahlen oder Grenzwerten berechnet sind: %1. Neu berechnen fügt zu jeder eine neue Bewertung hinzu; die geltende Bewertung bleibt.</translation>
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
        <source>%1, %2: %3</source>
        <translation>%1, %2: %3</translation>
    </message>
    <message>
        <source>Cut off three times in a row or more: %1</source>
        <translation>Dreimal oder öfter in Folge unterbrochen: %1</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1, %2: %3 attempts cut off, the last %4. Recorded: %5</source>
        <translation>%1, %2: %3 Versuche unterbrochen, der letzte %4. Aufgezeichnet: %5</translation>
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
        <source>the newest 500</source>
        <translation>die neuesten 500</translation>
    </message>
    <message>
        <source>attempts: %1</source>
        <translation>Versuche: %1</translation>
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
        <source>Show older ones</source>
        <translation>Ältere zeigen</translation>
    </message>
    <message>
        <source>Texts about an attempt are not shown here; they are visible to people who may read the attempt. Anyone with access to the file can rewrite the chain: compare its head with the one in a report.</source>
        <translation>Texte zu einem Versuch werden hier nicht gezeigt; sie sind für Personen sichtbar, die den Versuch lesen dürfen. Wer Zugriff auf die Datei hat, kann die Kette neu schreiben: Vergleichen Sie ihren neuesten Hash mit dem in einem Bericht.</translation>
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
        <source>entries shown: %1</source>
        <translation>gezeigte Einträge: %1</translation>
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
</context>
<context>
    <name>fulcrum::ui::BriefingPage</name>
    <message>
        <source>One mouse for each hand: practice only, because no limits exist for two mice. F1 shows what their buttons do.</source>
        <translation>Je eine Maus für jede Hand: nur Übung, weil es für zwei Mäuse keine Grenzwerte gibt. F1 zeigt, was ihre Tasten tun.</translation>
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
        <source>A simulated expert performs the task. Nothing is stored. Press Escape to stop.</source>
        <translation>Ein simulierter Experte führt die Aufgabe durch. Es wird nichts gespeichert. Drücken Sie Esc, um zu beenden.</translation>
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
        <source>With the ghost of an expert</source>
        <translation>Mit dem Schattenbild eines Experten</translation>
    </message>
    <message>
        <source>Translucent instruments show an expert&apos;s next movement and wait for you. The scene is then that of the demonstration.</source>
        <translation>Durchscheinende Instrumente zeigen die nächste Bewegung eines Experten und warten auf Sie. Die Szene ist dann die der Vorführung.</translation>
    </message>
    <message>
        <source>the beginning</source>
        <translation>am Anfang</translation>
    </message>
    <message>
        <source>For you this task is %1; until then it is practice only.</source>
        <translation>Für Sie ist diese Aufgabe %1; bis dahin ist sie nur Übung.</translation>
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
        <source>Time limit %1 · outcome: %2</source>
        <translation>Zeitlimit %1 · Ergebnis: %2</translation>
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
        <source>Fidelity of the simulation: its effect on the score is not measured.</source>
        <translation>Genauigkeit der Simulation: Die Wirkung auf die Bewertung ist nicht gemessen.</translation>
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
        <source>Fidelity of the simulation, compared with %1 (synthetic operators). %2.</source>
        <translation>Genauigkeit der Simulation, verglichen mit %1 (synthetische Operateure). %2.</translation>
    </message>
    <message>
        <source>This site has its own tissue values (version %1): cutting parameters differ from the scene&apos;s.</source>
        <translation>Dieser Standort hat eigene Gewebewerte (Version %1): Die Schnittparameter weichen von denen der Szene ab.</translation>
    </message>
    <message>
        <source>Gates based on the experts&apos; range are not scored: %1.</source>
        <translation>Kriterien, die auf dem Bereich der Experten beruhen, werden nicht ausgewertet: %1.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::CertificateCard</name>
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
</context>
<context>
    <name>fulcrum::ui::CohortGrid</name>
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
</context>
<context>
    <name>fulcrum::ui::CohortPage</name>
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
        <source>people: n = %1</source>
        <translation>Personen: n = %1</translation>
    </message>
    <message>
        <source> · synthetic left out: %1</source>
        <translation> · synthetische ausgelassen: %1</translation>
    </message>
    <message>
        <source> · counting attempts only; device classes are never pooled</source>
        <translation> · nur zählende Versuche; Geräteklassen werden nie zusammengefasst</translation>
    </message>
    <message>
        <source>Benchmark sets: %1
Metrics: %2</source>
        <translation>Richtwertsätze: %1
Kennzahlen: %2</translation>
    </message>
    <message>
        <source>Needs attention (%1)</source>
        <translation>Handlungsbedarf (%1)</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::CohortsPage</name>
    <message>
        <source>Assign cohorts</source>
        <translation>Gruppen zuteilen</translation>
    </message>
    <message>
        <source>name of a new cohort</source>
        <translation>Name einer neuen Gruppe</translation>
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
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Saved.</source>
        <translation>Gespeichert.</translation>
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
        <source>None yet.</source>
        <translation>Noch keine.</translation>
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
</context>
<context>
    <name>fulcrum::ui::Context</name>
    <message>
        <source>Interrupted attempts could not be scored now. It is tried again at the next sign-in: %1</source>
        <translation>Unterbrochene Versuche konnten jetzt nicht ausgewertet werden. Bei der nächsten Anmeldung wird es erneut versucht: %1</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::CurriculumCard</name>
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
        <source>reason, kept in the audit log</source>
        <translation>Grund, bleibt im Protokoll</translation>
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
        <source>There is a newer version, %1. People stay on their version until an educator moves them.</source>
        <translation>Es gibt eine neuere Version, %1. Personen bleiben auf ihrer Version, bis ein Ausbilder sie umstellt.</translation>
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
</context>
<context>
    <name>fulcrum::ui::CurriculumPage</name>
    <message>
        <source>When a trainee is proficient in a task follows from its pass rule. Choose a task, move the sliders, and see what another rule would do.</source>
        <translation>Wann eine Aufgabe sicher beherrscht wird, folgt aus ihrer Bestehensregel. Wählen Sie eine Aufgabe, bewegen Sie die Regler und sehen Sie, was eine andere Regel bewirken würde.</translation>
    </message>
    <message>
        <source>Tasks of the curriculum</source>
        <translation>Aufgaben des Curriculums</translation>
    </message>
    <message>
        <source>Back to the rule in force</source>
        <translation>Zurück zur geltenden Regel</translation>
    </message>
    <message>
        <source>Exact for trainees who pass every attempt with the same chance. Learning, the two days and the variants that a rule may ask for are left out: they delay it further.</source>
        <translation>Genau für Trainierende, die jeden Versuch mit derselben Wahrscheinlichkeit bestehen. Lernen, die zwei Tage und die Varianten, die eine Regel verlangen kann, sind nicht berücksichtigt: Sie verzögern es weiter.</translation>
    </message>
    <message>
        <source>New version</source>
        <translation>Neue Version</translation>
    </message>
    <message>
        <source>File of the new version</source>
        <translation>Datei der neuen Version</translation>
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
    <message>
        <source>Change the rule of a task first.</source>
        <translation>Ändern Sie zuerst die Regel einer Aufgabe.</translation>
    </message>
    <message>
        <source>Wrote %1. It takes effect once it is installed: the manual says how.</source>
        <translation>%1 wurde geschrieben. Sie gilt, sobald sie installiert ist: Das Handbuch sagt, wie.</translation>
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
        <source>Voided by %1 on %2: %3. It does not count.</source>
        <translation>Für ungültig erklärt von %1 am %2: %3. Er zählt nicht.</translation>
    </message>
    <message>
        <source>A copy was stored for the person who performed it.</source>
        <translation>Für die Person, die ihn durchgeführt hat, wurde eine Kopie gespeichert.</translation>
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
        <source>Practice from goal %1 of a demonstration: never scored.</source>
        <translation>Übung ab Schritt %1 einer Vorführung: nie ausgewertet.</translation>
    </message>
    <message>
        <source>Practice taken over from an attempt at %1: never scored.</source>
        <translation>Übung, übernommen aus einem Versuch bei %1: nie ausgewertet.</translation>
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
        <source>The limits are provisional (synthetic operators): they allow &quot;passed (provisional)&quot;, never proficiency.</source>
        <translation>Die Grenzwerte sind vorläufig (synthetische Operateure): Sie erlauben „bestanden (vorläufig)“, nie „sicher beherrscht“.</translation>
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
        <source>Show name and score; my rating is then not blind</source>
        <translation>Name und Bewertung zeigen; meine Beurteilung ist dann nicht blind</translation>
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
        <source>Look again</source>
        <translation>Erneut suchen</translation>
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
        <source>In use: %1. The environment variable FULCRUM_DEVICE names the device when Fulcrum starts; without it, mouse and keyboard are used.</source>
        <translation>In Gebrauch: %1. Die Umgebungsvariable FULCRUM_DEVICE nennt beim Start von Fulcrum das Gerät; ohne sie dienen Maus und Tastatur.</translation>
    </message>
    <message>
        <source>%1 readings per second</source>
        <translation>%1 Messwerte je Sekunde</translation>
    </message>
    <message>
        <source>Its readings are shown here after the first attempt with it, which opens the device.</source>
        <translation>Seine Messwerte erscheinen hier nach dem ersten Versuch mit ihm, der das Gerät öffnet.</translation>
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
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Reports (*.pdf *.csv *.xlsx *.json)</source>
        <translation>Berichte (*.pdf *.csv *.xlsx *.json)</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::FirstStartPage</name>
    <message>
        <source>A simulator for laparoscopic rectal surgery with its training programme: tasks, scores with their evidence, reviews and reports.</source>
        <translation>Ein Simulator für die laparoskopische Rektumchirurgie mit seinem Ausbildungsprogramm: Aufgaben, Bewertungen mit ihren Belegen, Durchsichten und Berichte.</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>Create programme</source>
        <translation>Programm anlegen</translation>
    </message>
    <message>
        <source>For a department or a training centre. You become its first administrator. Then you add people, roles and cohorts.</source>
        <translation>Für eine Abteilung oder ein Ausbildungszentrum. Sie werden der erste Administrator. Danach fügen Sie Personen, Rollen und Gruppen hinzu.</translation>
    </message>
    <message>
        <source>Look around</source>
        <translation>Umsehen</translation>
    </message>
    <message>
        <source>A demonstration programme with a simulated cohort: no real people, but real simulated attempts. You can practise in it, and every screen has content.</source>
        <translation>Ein Vorführprogramm mit einer simulierten Gruppe: keine echten Personen, aber echte simulierte Versuche. Sie können darin üben, und jede Seite hat Inhalt.</translation>
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
        <source>letters, digits, . _ - @</source>
        <translation>Buchstaben, Ziffern, . _ - @</translation>
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
        <source>Create</source>
        <translation>Anlegen</translation>
    </message>
    <message>
        <source>Your recovery code</source>
        <translation>Ihr Wiederherstellungscode</translation>
    </message>
    <message>
        <source>It is shown only now. Write it down and lock it away: it is the only way for the last administrator to set a new password.</source>
        <translation>Er wird nur jetzt angezeigt. Schreiben Sie ihn auf und schließen Sie ihn weg: Nur damit kann der letzte Administrator ein neues Passwort setzen.</translation>
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
        <source>Simulating the demonstration cohort …</source>
        <translation>Vorführgruppe wird simuliert …</translation>
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
        <source>Every gate must be met. Select a row to jump to the moment that decided it, Explain to read what is measured.</source>
        <translation>Jedes Kriterium muss erfüllt sein. Wählen Sie eine Zeile, um zum entscheidenden Zeitpunkt zu springen, oder „Erklären“, um zu lesen, was gemessen wird.</translation>
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
</context>
<context>
    <name>fulcrum::ui::HomePage</name>
    <message>
        <source>Other exercises</source>
        <translation>Weitere Aufgaben</translation>
    </message>
    <message>
        <source>Hello, %1</source>
        <translation>Guten Tag, %1</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Als Nächstes</translation>
    </message>
    <message>
        <source>Open the briefing</source>
        <translation>Einweisung öffnen</translation>
    </message>
    <message>
        <source>Interrupted before you signed in: %1</source>
        <translation>Unterbrochen, bevor Sie sich angemeldet haben: %1</translation>
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
        <source>not counting: %1</source>
        <translation>nicht zählend: %1</translation>
    </message>
    <message>
        <source>Briefing</source>
        <translation>Einweisung</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
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
        <source>T next · B pedal</source>
        <translation>T nächstes · B Pedal</translation>
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
        <source>new account</source>
        <translation>neues Konto</translation>
    </message>
    <message>
        <source>gets a role</source>
        <translation>erhält eine Rolle</translation>
    </message>
    <message>
        <source>is there already</source>
        <translation>ist schon da</translation>
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
        <source>Import a list</source>
        <translation>Eine Liste importieren</translation>
    </message>
    <message>
        <source>A folder with OneRoster CSV files, or one CSV file with the columns login, name, role and cohort. Nobody is renamed, deactivated or removed.</source>
        <translation>Ein Ordner mit OneRoster-CSV-Dateien oder eine CSV-Datei mit den Spalten login, name, role und cohort. Niemand wird umbenannt, deaktiviert oder entfernt.</translation>
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
        <source>Look</source>
        <translation>Ansehen</translation>
    </message>
    <message>
        <source>List of people</source>
        <translation>Liste von Personen</translation>
    </message>
    <message>
        <source>CSV (*.csv)</source>
        <translation>CSV (*.csv)</translation>
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
        <source>Line: the limit; the filled part of the bar meets it. Box: the experts (mean ± one standard deviation). Diamond: your last value with this device. * provisional limit.</source>
        <translation>Strich: die Grenze; der gefüllte Teil des Balkens erfüllt sie. Kasten: die Experten (Mittelwert ± eine Standardabweichung). Raute: Ihr letzter Wert mit diesem Gerät. * vorläufiger Grenzwert.</translation>
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
</context>
<context>
    <name>fulcrum::ui::MainWindow</name>
    <message>
        <source>Fulcrum</source>
        <translation>Fulcrum</translation>
    </message>
    <message>
        <source>Demonstration: the people are not real, and neither are their attempts.</source>
        <translation>Vorführung: Die Personen sind nicht echt, ihre Versuche ebenso wenig.</translation>
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
        <source>The attempt was closed as interrupted and stored.</source>
        <translation>Der Versuch wurde als unterbrochen geschlossen und gespeichert.</translation>
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
        <source>neither: context only</source>
        <translation>weder noch: nur zur Einordnung</translation>
    </message>
    <message>
        <source>strong: several studies separate experts from novices with it</source>
        <translation>stark: Mehrere Studien unterscheiden damit Experten von Anfängern</translation>
    </message>
    <message>
        <source>moderate: one study, or several with small groups</source>
        <translation>mittel: eine Studie oder mehrere mit kleinen Fallzahlen</translation>
    </message>
    <message>
        <source>expert opinion: no published study separates experts from novices with it</source>
        <translation>Expertenmeinung: Keine veröffentlichte Studie unterscheidet damit Experten von Anfängern</translation>
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
        <source>What the simulator measures. A gate is a pass criterion of a task: every gate must be met.</source>
        <translation>Was der Simulator misst. Ein Kriterium entscheidet über das Bestehen einer Aufgabe: Jedes Kriterium muss erfüllt sein.</translation>
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
        <source>Better</source>
        <translation>Besser</translation>
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
        <source>Select a row to jump to its moment, Explain to read what is measured.</source>
        <translation>Wählen Sie eine Zeile, um zu ihrem Zeitpunkt zu springen, oder „Erklären“, um zu lesen, was gemessen wird.</translation>
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
        <source>Better</source>
        <translation>Besser</translation>
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
</context>
<context>
    <name>fulcrum::ui::OverviewView</name>
    <message>
        <source>%1 of %2 (%3 %, %4 to %5 %)</source>
        <translation>%1 von %2 (%3 %, %4 bis %5 %)</translation>
    </message>
    <message>
        <source>not yet by half</source>
        <translation>noch nicht die Hälfte</translation>
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
        <source>Passed at least once, of those who tried, with the 95 % interval. Days from the first attempt that counts: median over people (Kaplan and Meier), with its 95 % interval. Provisional limits allow a pass, never proficiency.</source>
        <translation>Mindestens einmal bestanden, von denen, die es versucht haben, mit dem 95-%-Intervall. Tage ab dem ersten Versuch, der zählt: Median über die Personen (Kaplan und Meier) mit seinem 95-%-Intervall. Mit vorläufigen Grenzwerten ist „bestanden“ möglich, nie „sicher beherrscht“.</translation>
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
        <source>Half after</source>
        <translation>Hälfte nach</translation>
    </message>
    <message>
        <source>Dashed, and in brackets: the rule in force, %1.</source>
        <translation>Gestrichelt und in Klammern: die geltende Regel, %1.</translation>
    </message>
    <message>
        <source>Every pass raises a sum, every failure lowers it more, never below 0; who reaches the limit is proficient.</source>
        <translation>Jeder bestandene Versuch hebt eine Summe, jeder andere senkt sie stärker, nie unter 0; wer die Grenze erreicht, beherrscht die Aufgabe sicher.</translation>
    </message>
    <message>
        <source>This is the rule in force.</source>
        <translation>Das ist die geltende Regel.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::PasswordPage</name>
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
        <source>Show the people who signed in here in the last 30 days on the sign-in screen</source>
        <translation>Auf der Anmeldeseite die Personen zeigen, die sich hier in den letzten 30 Tagen angemeldet haben</translation>
    </message>
    <message>
        <source>Add a person</source>
        <translation>Person hinzufügen</translation>
    </message>
    <message>
        <source>letters, digits, . _ - @</source>
        <translation>Buchstaben, Ziffern, . _ - @</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
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
        <source>1 on the day</source>
        <translation>1 am Tag</translation>
    </message>
    <message>
        <source>2 or 3</source>
        <translation>2 oder 3</translation>
    </message>
    <message>
        <source>4 or more</source>
        <translation>4 oder mehr</translation>
    </message>
    <message>
        <source>Days of practice</source>
        <translation>Übungstage</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::ProgressPage</name>
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
        <source>● passed   ✕ failed   ○ not scored   small: does not count. Device classes are shown separately. Thick line: the fitted curve; its band: where it levels off (95 % interval). Select a point to open the attempt.</source>
        <translation>● bestanden   ✕ nicht bestanden   ○ nicht ausgewertet   klein: zählt nicht. Geräteklassen werden getrennt gezeigt. Dicke Linie: die angepasste Kurve; ihr Band: wo sie abflacht (95-%-Intervall). Wählen Sie einen Punkt, um den Versuch zu öffnen.</translation>
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
        <source>%1 · counting attempts: %2 · passed: %3</source>
        <translation>%1 · zählende Versuche: %2 · bestanden: %3</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>experts (mean ± one standard deviation)</source>
        <translation>Experten (Mittelwert ± eine Standardabweichung)</translation>
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
        <source>The draft is kept. A rating that was handed in is never changed.</source>
        <translation>Der Entwurf bleibt erhalten. Eine abgegebene Beurteilung wird nicht mehr geändert.</translation>
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
        <source>Ratings by others: %1. You see them once you have handed in yours.</source>
        <translation>Beurteilungen anderer: %1. Sie sehen sie, sobald Sie Ihre abgegeben haben.</translation>
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
</context>
<context>
    <name>fulcrum::ui::ReportTexts</name>
    <message>
        <source>DEMONSTRATION</source>
        <translation>VORFÜHRUNG</translation>
    </message>
    <message>
        <source>attempt report</source>
        <translation>Versuchsbericht</translation>
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
        <source>Provisional limits (synthetic operators): they allow &quot;passed (provisional)&quot;, never proficiency or a certificate.</source>
        <translation>Vorläufige Grenzwerte (synthetische Operateure): Sie erlauben „bestanden (vorläufig)“, nie „sicher beherrscht“ und nie ein Zertifikat.</translation>
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
        <source>login %1</source>
        <translation>Anmeldename %1</translation>
    </message>
    <message>
        <source>as of %1</source>
        <translation>Stand %1</translation>
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
        <source>The text in the picture of an attempt grows as far as there is room for it.</source>
        <translation>Die Schrift im Bild eines Versuchs wächst, soweit dort Platz ist.</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Messages about errors are still in English.</source>
        <translation>Fehlermeldungen sind noch auf Englisch.</translation>
    </message>
    <message>
        <source>The environment variable FULCRUM_LANGUAGE chooses the language of this station. Start Fulcrum without it to choose here.</source>
        <translation>Die Umgebungsvariable FULCRUM_LANGUAGE legt die Sprache dieser Station fest. Starten Sie Fulcrum ohne sie, um hier zu wählen.</translation>
    </message>
    <message>
        <source>They are remembered, and are the same for everyone who uses this account of the computer.</source>
        <translation>Sie bleiben gespeichert und sind für alle gleich, die dieses Benutzerkonto des Rechners verwenden.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::SignInPage</name>
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
        <source>Attempts that were running when the program last ended: %1. They are listed as interrupted; nothing that was recorded is lost.</source>
        <translation>Versuche, die beim letzten Ende der Software noch liefen: %1. Sie sind als unterbrochen aufgeführt; von dem, was aufgezeichnet wurde, ist nichts verloren.</translation>
    </message>
    <message>
        <source>%1 — %2</source>
        <translation>%1 — %2</translation>
    </message>
    <message>
        <source>Type your login and your password.</source>
        <translation>Geben Sie Ihren Anmeldenamen und Ihr Passwort ein.</translation>
    </message>
    <message>
        <source>Signing in …</source>
        <translation>Anmeldung läuft …</translation>
    </message>
    <message>
        <source>Password changed. Your new recovery code, shown only now: %1</source>
        <translation>Passwort geändert. Ihr neuer Wiederherstellungscode, nur jetzt angezeigt: %1</translation>
    </message>
    <message>
        <source>Checking the recovery code …</source>
        <translation>Wiederherstellungscode wird geprüft …</translation>
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
        <source>reason, kept in the audit log</source>
        <translation>Grund, bleibt im Protokoll</translation>
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
        <source>Writes everything into one file in the background. Keep it on another disk; it is as confidential as the store itself.</source>
        <translation>Schreibt alles im Hintergrund in eine einzige Datei. Bewahren Sie sie auf einem anderen Datenträger auf; sie ist so vertraulich wie der Datenbestand selbst.</translation>
    </message>
    <message>
        <source>Back up …</source>
        <translation>Sichern …</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Reads the whole store (pages, references, audit log, recordings, scores) and lists any damage.</source>
        <translation>Liest den ganzen Datenbestand (Seiten, Verweise, Protokoll, Aufzeichnungen, Bewertungen) und führt jeden Schaden auf.</translation>
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
        <source>How many</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>What is wrong</source>
        <translation>Was nicht stimmt</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
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
        <source>Resolution: %1 % of the window&apos;s, %2 % inside the pelvis, so that a picture takes less than %3 ms. If it takes longer, the resolution is reduced to %4 % of that; it rises again when there is time.</source>
        <translation>Auflösung: %1 % der Auflösung des Fensters, im Becken %2 %, damit ein Bild weniger als %3 ms braucht. Braucht es länger, wird die Auflösung auf %4 % davon gesenkt; sie steigt wieder, wenn Zeit ist.</translation>
    </message>
    <message>
        <source>Resolution: that of the window. If a picture takes longer than %1 ms, it is reduced to as little as %2 %; it rises again when there is time.</source>
        <translation>Auflösung: die des Fensters. Braucht ein Bild länger als %1 ms, wird sie auf bis zu %2 % gesenkt; sie steigt wieder, wenn Zeit ist.</translation>
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
        <source>The scene cannot be drawn on this machine: %1</source>
        <translation>Die Szene kann auf diesem Rechner nicht gezeichnet werden: %1</translation>
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
        <source>✕ The store is damaged. Copy the file away before anything else, then restore the newest backup.</source>
        <translation>✕ Der Datenbestand ist beschädigt. Kopieren Sie zuallererst die Datei an einen anderen Ort, stellen Sie dann die neueste Sicherung wieder her.</translation>
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
</context>
<context>
    <name>fulcrum::ui::TaskHeader</name>
    <message>
        <source>%1: not practised yet</source>
        <translation>%1: noch nicht geübt</translation>
    </message>
    <message>
        <source>%1: attempts %2, passed %3</source>
        <translation>%1: Versuche %2, bestanden %3</translation>
    </message>
    <message>
        <source>Go to the briefing</source>
        <translation>Zur Einweisung</translation>
    </message>
    <message>
        <source>Go to the briefing with this variant</source>
        <translation>Zur Einweisung mit dieser Variante</translation>
    </message>
    <message>
        <source>Outcome: %1 · time limit %2</source>
        <translation>Ergebnis: %1 · Zeitlimit %2</translation>
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
        <source>This attempt is assessed and has begun: if you abandon it, it is failed. Everything recorded so far is kept.</source>
        <translation>Dieser Versuch wird bewertet und hat begonnen: Wenn Sie ihn abbrechen, ist er nicht bestanden. Alles bisher Aufgezeichnete bleibt erhalten.</translation>
    </message>
    <message>
        <source>It is stored as abandoned and does not count.</source>
        <translation>Er wird als abgebrochen gespeichert und zählt nicht.</translation>
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
        <source>The force at which a blade cuts into a tissue and through it. What you set here applies for attempts that begin afterwards; every attempt keeps the scene that it was performed in.</source>
        <translation>Die Kraft, bei der eine Klinge in ein Gewebe einschneidet und es durchtrennt. Was Sie hier festlegen, gilt für Versuche, die danach beginnen; jeder Versuch behält die Szene, in der er durchgeführt wurde.</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Aufgaben</translation>
    </message>
    <message>
        <source>No task of this programme has tissue that a blade cuts.</source>
        <translation>Keine Aufgabe dieses Programms hat Gewebe, das eine Klinge schneidet.</translation>
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
        <source>why (kept in the audit log)</source>
        <translation>Grund (steht im Protokoll)</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Setzen</translation>
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
        <source>Attempts are not compared with the task&apos;s limits, and gates based on them are not scored: %1. Build a benchmark set in this tissue: fulcrum benchmark build %2 --operators --db %3</source>
        <translation>Versuche werden nicht mit den Grenzwerten der Aufgabe verglichen, und darauf beruhende Kriterien werden nicht bewertet: %1. Erstellen Sie einen Richtwertsatz mit diesem Gewebe: fulcrum benchmark build %2 --operators --db %3</translation>
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
</context>
<context>
    <name>fulcrum::ui::ToRatePage</name>
    <message>
        <source>Rate attempts</source>
        <translation>Versuche beurteilen</translation>
    </message>
    <message>
        <source>Names and scores are left out here. An attempt whose name and score you have not opened is rated blind.</source>
        <translation>Namen und Bewertungen fehlen hier. Ein Versuch, dessen Namen und Bewertung Sie nicht geöffnet haben, wird blind beurteilt.</translation>
    </message>
    <message>
        <source>Also those that I have rated</source>
        <translation>Auch die von mir beurteilten</translation>
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
        <source>Your ratings</source>
        <translation>Ihre Beurteilungen</translation>
    </message>
    <message>
        <source>Blind</source>
        <translation>Blind</translation>
    </message>
    <message>
        <source>Open to rate</source>
        <translation>Zum Beurteilen öffnen</translation>
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
        <source>Attempts: %1</source>
        <translation>Versuche: %1</translation>
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
        <source>mm/s</source>
        <translation>mm/s</translation>
    </message>
    <message>
        <source>speed (mm/s)</source>
        <translation>Geschwindigkeit (mm/s)</translation>
    </message>
    <message>
        <source>Scroll to zoom, drag to move, click to jump to a moment, double-click to show everything.</source>
        <translation>Mausrad zoomt, Ziehen verschiebt, Klick springt zu einem Zeitpunkt, Doppelklick zeigt alles.</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Was geschah</translation>
    </message>
    <message>
        <source>penalties only</source>
        <translation>nur Fehler</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>limit, %1</source>
        <translation>Grenze, %1</translation>
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
        <source>%1: after %n attempts the curve levels off at %2 points (95 % interval %3 to %4), below the pass mark of %5.</source>
        <translation>%1: Nach %n Versuchen erreicht die Kurve ein Plateau bei %2 Punkten (95-%-Intervall %3 bis %4), unter der Bestehensgrenze von %5.</translation>
    </message>
    <message>
        <source>%1: %n attempts without proficiency.</source>
        <translation>%1: %n Versuche, noch nicht sicher beherrscht.</translation>
    </message>
    <message>
        <source>No practice for %n days, since %1, and tasks are left.</source>
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
        <source>You do not hold this role.</source>
        <translation>Sie haben diese Rolle nicht.</translation>
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
        <source>It does not meet the limit of %1: something has to change.</source>
        <translation>Sie erfüllt den Grenzwert %1 nicht: Etwas muss sich ändern.</translation>
    </message>
    <message>
        <source>It meets the limit of %1 since attempt %2.</source>
        <translation>Sie erfüllt den Grenzwert %1 seit Versuch %2.</translation>
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
        <source>You are proficient in it; a check is due since %1.</source>
        <translation>Sie beherrschen diese Aufgabe sicher; eine Kontrolle ist seit %1 fällig.</translation>
    </message>
    <message>
        <source>Your results have fallen below proficiency; three passes in four attempts restore it.</source>
        <translation>Ihre Ergebnisse reichen nicht mehr für „sicher beherrscht“; drei bestandene von vier Versuchen stellen es wieder her.</translation>
    </message>
    <message>
        <source>You have not tried this task of the stage %1 yet.</source>
        <translation>Diese Aufgabe der Stufe %1 haben Sie noch nicht versucht.</translation>
    </message>
    <message>
        <source>Of the tasks left in the stage %1 it is the one you have not practised for longest (%2).</source>
        <translation>Von den übrigen Aufgaben der Stufe %1 haben Sie diese am längsten nicht geübt (%2).</translation>
    </message>
    <message>
        <source>What is left cannot be assessed with mouse and keyboard; you can practise this task.</source>
        <translation>Was noch übrig ist, kann mit Maus und Tastatur nicht bewertet werden; diese Aufgabe können Sie üben.</translation>
    </message>
    <message>
        <source>Every task is done; this is the one that you performed longest ago (%1).</source>
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
    <name>fulcrum::ui::standing</name>
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
        <source>Two passes on one day complete it.</source>
        <translation>Zwei bestandene Versuche an einem Tag schließen sie ab.</translation>
    </message>
    <message>
        <source>Three passes in four attempts restore it.</source>
        <translation>Drei bestandene von vier Versuchen stellen es wieder her.</translation>
    </message>
    <message>
        <source>The rule is met on provisional limits: later tasks unlock, but nobody is declared proficient.</source>
        <translation>Die Regel ist mit vorläufigen Grenzwerten erfüllt: Spätere Aufgaben werden freigegeben, aber für niemanden wird „sicher beherrscht“ festgestellt.</translation>
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
        <source>%1 % of the way to proficiency.</source>
        <translation>%1 % des Weges bis „sicher beherrscht“.</translation>
    </message>
</context>
<context>
    <name>fulcrum::ui::text</name>
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
