<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>assets</name>
    <message>
        <source>Laparoscopic rectal surgery</source>
        <translation>Laparoskopische Rektumchirurgie</translation>
    </message>
    <message>
        <source>Instruments</source>
        <translation>Instrumente</translation>
    </message>
    <message>
        <source>Tissue</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>Dissection</source>
        <translation>Präparation</translation>
    </message>
    <message>
        <source>30° camera</source>
        <translation>30°-Kamera</translation>
    </message>
    <message>
        <source>You hold the scope. A 30° scope looks to the side: the light post turns the direction in which it looks around the shaft, the camera head turns the image alone. Twelve balls lie in cups, one after another is lit. Bring the lit ball to the middle of the image at the size of the circle, with the horizon level, and keep it there for a second. Then follow a tip that moves. Touch nothing with the lens.</source>
        <translation>Sie führen die Optik. Eine 30°-Optik blickt zur Seite: Der Lichtanschluss dreht die Blickrichtung um den Schaft, der Kamerakopf dreht nur das Bild. Zwölf Kugeln liegen in Bechern, eine nach der anderen leuchtet. Bringen Sie die leuchtende Kugel in die Bildmitte, so groß wie der Kreis und mit waagerechtem Horizont, und halten Sie sie dort eine Sekunde lang. Folgen Sie danach einer Spitze, die sich bewegt. Berühren Sie mit der Linse nichts.</translation>
    </message>
    <message>
        <source>Twelve targets framed, a moving tip followed for 20 seconds</source>
        <translation>Zwölf Ziele eingestellt, einer bewegten Spitze 20 Sekunden lang gefolgt</translation>
    </message>
    <message>
        <source>Find the lit ball; turn the light post until you see into its cup.</source>
        <translation>Suchen Sie die leuchtende Kugel; drehen Sie den Lichtanschluss, bis Sie in ihren Becher sehen.</translation>
    </message>
    <message>
        <source>Move the lens in or out until the ball fills the circle.</source>
        <translation>Bewegen Sie die Linse vor oder zurück, bis die Kugel den Kreis ausfüllt.</translation>
    </message>
    <message>
        <source>Turn the camera head until the horizon is level.</source>
        <translation>Drehen Sie den Kamerakopf, bis der Horizont waagerecht ist.</translation>
    </message>
    <message>
        <source>Hold still for a second.</source>
        <translation>Halten Sie eine Sekunde lang still.</translation>
    </message>
    <message>
        <source>After twelve balls, keep the moving tip in the circle for 20 seconds in all.</source>
        <translation>Halten Sie nach zwölf Kugeln die bewegte Spitze insgesamt 20 Sekunden lang im Kreis.</translation>
    </message>
    <message>
        <source>Scope in the middle</source>
        <translation>Optik in der Mitte</translation>
    </message>
    <message>
        <source>Scope from the right</source>
        <translation>Optik von rechts</translation>
    </message>
    <message>
        <source>Scope from the left</source>
        <translation>Optik von links</translation>
    </message>
    <message>
        <source>Frame each lit ball: middle, size, level horizon</source>
        <translation>Leuchtende Kugeln: Mitte, Größe, Horizont waagerecht</translation>
    </message>
    <message>
        <source>Keep the moving tip framed</source>
        <translation>Bewegte Spitze im Kreis halten</translation>
    </message>
    <message>
        <source>Training limit of this task: the lens may touch something twice</source>
        <translation>Trainingsgrenzwert dieser Aufgabe: Die Linse darf zweimal etwas berühren</translation>
    </message>
    <message>
        <source>withdraw a little before you look elsewhere</source>
        <translation>ziehen Sie die Optik etwas zurück, bevor Sie woandershin blicken</translation>
    </message>
    <message>
        <source>a hot lens burns what it touches, and a smeared one shows nothing</source>
        <translation>eine heiße Linse verbrennt, was sie berührt, und eine verschmierte zeigt nichts</translation>
    </message>
    <message>
        <source>Fulcrum targeting</source>
        <translation>Zielen am Drehpunkt</translation>
    </message>
    <message>
        <source>Your instruments pivot where they pass through the abdominal wall. When your hand goes left, the tip goes right; when your hand goes up, the tip goes down. In this task you learn to reach a point at the first attempt and to judge depth on a flat screen. Ten spheres appear one after another for the left hand, then ten for the right. Touch each one lightly and stay on it for one second.</source>
        <translation>Ihre Instrumente drehen sich um den Punkt, an dem sie durch die Bauchdecke treten. Geht Ihre Hand nach links, geht die Spitze nach rechts; geht Ihre Hand nach oben, geht die Spitze nach unten. In dieser Aufgabe lernen Sie, einen Punkt beim ersten Versuch zu erreichen und auf einem flachen Bildschirm die Tiefe einzuschätzen. Nacheinander erscheinen zehn Kugeln für die linke Hand, dann zehn für die rechte. Berühren Sie jede leicht und bleiben Sie eine Sekunde lang auf ihr.</translation>
    </message>
    <message>
        <source>Ten spheres held with each hand</source>
        <translation>Zehn Kugeln mit jeder Hand gehalten</translation>
    </message>
    <message>
        <source>Find the lit sphere before you move.</source>
        <translation>Suchen Sie die leuchtende Kugel, bevor Sie sich bewegen.</translation>
    </message>
    <message>
        <source>Move the tip to it in one smooth movement and slow down before you arrive.</source>
        <translation>Führen Sie die Spitze in einer fließenden Bewegung zu ihr und werden Sie vor dem Ziel langsamer.</translation>
    </message>
    <message>
        <source>Touch the sphere lightly and hold still for one second, until the ring closes.</source>
        <translation>Berühren Sie die Kugel leicht und halten Sie eine Sekunde lang still, bis sich der Ring schließt.</translation>
    </message>
    <message>
        <source>Keep the tip in the picture at all times.</source>
        <translation>Behalten Sie die Spitze immer im Bild.</translation>
    </message>
    <message>
        <source>Left hand first, then the right hand.</source>
        <translation>Zuerst die linke Hand, dann die rechte Hand.</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>Deeper spheres</source>
        <translation>Tiefere Kugeln</translation>
    </message>
    <message>
        <source>Trocars further right</source>
        <translation>Trokare weiter rechts</translation>
    </message>
    <message>
        <source>Left hand: touch the lit sphere and hold it</source>
        <translation>Linke Hand: leuchtende Kugel berühren und halten</translation>
    </message>
    <message>
        <source>Right hand: touch the lit sphere and hold it</source>
        <translation>Rechte Hand: leuchtende Kugel berühren und halten</translation>
    </message>
    <message>
        <source>Training limit of this task: a firm press on a rigid sphere</source>
        <translation>Trainingsgrenzwert dieser Aufgabe: ein kräftiger Druck auf eine starre Kugel</translation>
    </message>
    <message>
        <source>slow down before the sphere and stop as soon as it lights up</source>
        <translation>werden Sie vor der Kugel langsamer und halten Sie an, sobald sie aufleuchtet</translation>
    </message>
    <message>
        <source>a push that hurts tissue must stop an attempt, however seldom it happens</source>
        <translation>ein Druck, der Gewebe verletzt, muss zum Nichtbestehen führen, so selten er auch vorkommt</translation>
    </message>
    <message>
        <source>Training limit of this task: the tip is in the image for seven tenths of the time</source>
        <translation>Trainingsgrenzwert dieser Aufgabe: Die Spitze ist sieben Zehntel der Zeit im Bild</translation>
    </message>
    <message>
        <source>keep the camera on the lit sphere and the tip in the image</source>
        <translation>halten Sie die Kamera auf die leuchtende Kugel und die Spitze im Bild</translation>
    </message>
    <message>
        <source>what an instrument does outside the image nobody sees</source>
        <translation>was ein Instrument außerhalb des Bildes tut, sieht niemand</translation>
    </message>
    <message>
        <source>Bimanual transfer</source>
        <translation>Beidhändige Übergabe</translation>
    </message>
    <message>
        <source>Both hands work together on a flat screen. Six rings lie around pegs on the left. Lift each ring with the left hand, hand it over to the right hand in the air and put it around a free peg on the right. Then bring all six back the same way: lift with the right hand, put down with the left. A ring that falls has to be lifted and handed over again.</source>
        <translation>Beide Hände arbeiten an einem flachen Bildschirm zusammen. Links liegen sechs Ringe um Stifte. Heben Sie jeden Ring mit der linken Hand an, übergeben Sie ihn in der Luft an die rechte Hand und legen Sie ihn rechts um einen freien Stift. Bringen Sie dann alle sechs auf demselben Weg zurück: mit der rechten anheben, mit der linken ablegen. Ein Ring, der fällt, muss erneut angehoben und übergeben werden.</translation>
    </message>
    <message>
        <source>Six rings around pegs on the right, then on the left</source>
        <translation>Sechs Ringe um Stifte auf der rechten, dann auf der linken Seite</translation>
    </message>
    <message>
        <source>Take the ring by the side that is nearest to your instrument.</source>
        <translation>Fassen Sie den Ring an der Seite, die Ihrem Instrument am nächsten ist.</translation>
    </message>
    <message>
        <source>Lift it clear of the pegs before you move sideways.</source>
        <translation>Heben Sie ihn über die Stifte, bevor Sie zur Seite gehen.</translation>
    </message>
    <message>
        <source>Hold the ring still while the other hand takes it; both hold it for a moment.</source>
        <translation>Halten Sie den Ring still, während die andere Hand ihn fasst; einen Augenblick lang halten ihn beide.</translation>
    </message>
    <message>
        <source>Let go only when the other jaws are closed.</source>
        <translation>Lassen Sie erst los, wenn das andere Maul geschlossen ist.</translation>
    </message>
    <message>
        <source>Lower the ring around a free peg until it touches the tray, then open the jaws.</source>
        <translation>Senken Sie den Ring um einen freien Stift, bis er die Platte berührt, und öffnen Sie dann das Maul.</translation>
    </message>
    <message>
        <source>Deeper tray</source>
        <translation>Tiefere Platte</translation>
    </message>
    <message>
        <source>Trocars closer together</source>
        <translation>Trokare näher beieinander</translation>
    </message>
    <message>
        <source>Lift with the left, hand over in the air, place on the right</source>
        <translation>Links anheben, in der Luft übergeben, rechts ablegen</translation>
    </message>
    <message>
        <source>Lift with the right, hand over in the air, place on the left</source>
        <translation>Rechts anheben, in der Luft übergeben, links ablegen</translation>
    </message>
    <message>
        <source>Training limit of this task: one ring may fall</source>
        <translation>Trainingsgrenzwert dieser Aufgabe: Ein Ring darf fallen</translation>
    </message>
    <message>
        <source>let go only when the other jaws are closed, and lower each ring to the tray</source>
        <translation>lassen Sie erst los, wenn das andere Maul geschlossen ist, und senken Sie jeden Ring bis auf die Platte</translation>
    </message>
    <message>
        <source>Training limit of this task: a firm press on a ring that lies on the tray</source>
        <translation>Trainingsgrenzwert dieser Aufgabe: ein kräftiger Druck auf einen Ring, der auf der Platte liegt</translation>
    </message>
    <message>
        <source>slow down before the ring and stop as soon as it moves</source>
        <translation>werden Sie vor dem Ring langsamer und halten Sie an, sobald er sich bewegt</translation>
    </message>
    <message>
        <source>Training limit of this task: about twice what holds a ring that is pulled with 3 N</source>
        <translation>Trainingsgrenzwert dieser Aufgabe: etwa das Doppelte dessen, was einen mit 3 N gezogenen Ring hält</translation>
    </message>
    <message>
        <source>close only until the ring no longer slips</source>
        <translation>schließen Sie nur so weit, bis der Ring nicht mehr abrutscht</translation>
    </message>
    <message>
        <source>a grip that is learned on rings crushes bowel</source>
        <translation>ein Griff, der an Ringen gelernt ist, zerquetscht den Darm</translation>
    </message>
    <message>
        <source>keep the camera on the ring and the tips in the image</source>
        <translation>halten Sie die Kamera auf den Ring und die Spitzen im Bild</translation>
    </message>
    <message>
        <source>Palpation of the sigmoid</source>
        <translation>Palpation des Sigmas</translation>
    </message>
    <message>
        <source>With a grasper you feel the bowel wall only through the shaft. Before you grasp bowel for the first time, learn how little force it takes to feel it. Rest the closed jaws of the left instrument on the middle of the sigmoid and stay in contact for ten seconds, then do the same with the right one a little further along.</source>
        <translation>Mit einer Fasszange spüren Sie die Darmwand nur über den Schaft. Bevor Sie zum ersten Mal Darm fassen, lernen Sie, wie wenig Kraft es braucht, um ihn zu spüren. Legen Sie das geschlossene Maul des linken Instruments auf die Mitte des Sigmas und bleiben Sie zehn Sekunden lang in Kontakt; tun Sie dann dasselbe mit dem rechten ein Stück weiter.</translation>
    </message>
    <message>
        <source>Ten seconds of light contact with each hand, wall intact</source>
        <translation>Zehn Sekunden leichter Kontakt mit jeder Hand, Wand unverletzt</translation>
    </message>
    <message>
        <source>Keep the jaws closed: nothing is grasped in this task.</source>
        <translation>Lassen Sie das Maul geschlossen: In dieser Aufgabe wird nichts gefasst.</translation>
    </message>
    <message>
        <source>Approach slowly and stop at the first resistance.</source>
        <translation>Nähern Sie sich langsam und halten Sie beim ersten Widerstand an.</translation>
    </message>
    <message>
        <source>Stay in contact for ten seconds; press only as hard as you need to stay in contact.</source>
        <translation>Bleiben Sie zehn Sekunden lang in Kontakt; drücken Sie nur so stark, wie es für den Kontakt nötig ist.</translation>
    </message>
    <message>
        <source>Left hand: rest on the middle of the sigmoid</source>
        <translation>Linke Hand: auf der Mitte des Sigmas ruhen</translation>
    </message>
    <message>
        <source>Right hand: rest on the sigmoid, further along</source>
        <translation>Rechte Hand: auf dem Sigma ruhen, ein Stück weiter</translation>
    </message>
    <message>
        <source>Training limit of this task: the bowel is felt well below it</source>
        <translation>Trainingsgrenzwert dieser Aufgabe: Der Darm ist weit darunter zu spüren</translation>
    </message>
    <message>
        <source>Any perforation is a critical error</source>
        <translation>Jede Perforation ist ein kritischer Fehler</translation>
    </message>
    <message>
        <source>Atraumatic bowel handling</source>
        <translation>Atraumatisches Fassen des Darms</translation>
    </message>
    <message>
        <source>Before any resection you inspect the bowel and lift the sigmoid out of the way. Graspers can bruise or tear the wall without your noticing, so the skill is to hold just firmly enough. Run 60 cm of the sigmoid hand over hand: one instrument holds while the other takes the bowel a little further along. Then grasp the sigmoid at its middle, lift it and hold it steady for 30 seconds.</source>
        <translation>Vor jeder Resektion mustern Sie den Darm durch und heben das Sigma aus dem Weg. Fasszangen können die Wand quetschen oder einreißen, ohne dass Sie es merken; die Kunst ist, gerade fest genug zu halten. Mustern Sie 60 cm des Sigmas Hand über Hand durch: Ein Instrument hält, während das andere den Darm ein Stück weiter fasst. Fassen Sie dann das Sigma in der Mitte, heben Sie es an und halten Sie es 30 Sekunden lang ruhig.</translation>
    </message>
    <message>
        <source>60 cm of bowel run and the sigmoid held clear, wall intact</source>
        <translation>60 cm Darm durchgemustert und das Sigma frei gehalten, Wand unverletzt</translation>
    </message>
    <message>
        <source>Take the bowel at the marked place with the jaws well open and close them gently.</source>
        <translation>Fassen Sie den Darm an der markierten Stelle mit weit geöffnetem Maul und schließen Sie es behutsam.</translation>
    </message>
    <message>
        <source>Keep hold with one hand until the other has a grasp 2 to 8 cm further along.</source>
        <translation>Halten Sie mit einer Hand fest, bis die andere 2 bis 8 cm weiter gefasst hat.</translation>
    </message>
    <message>
        <source>Continue hand over hand for 60 cm. Avoid traction: the bowel is attached to its mesentery.</source>
        <translation>Fahren Sie Hand über Hand 60 cm weit fort. Vermeiden Sie Zug: Der Darm hängt an seinem Mesenterium.</translation>
    </message>
    <message>
        <source>Then grasp the middle of the sigmoid, lift it 3 cm and hold it for 30 seconds without dropping it.</source>
        <translation>Fassen Sie dann die Mitte des Sigmas, heben Sie es 3 cm an und halten Sie es 30 Sekunden lang, ohne es fallen zu lassen.</translation>
    </message>
    <message>
        <source>If the bowel slips, keep your other grasp and grasp the bowel again where you lost it.</source>
        <translation>Wenn der Darm abrutscht, behalten Sie den anderen Griff und fassen Sie den Darm dort wieder, wo Sie ihn verloren haben.</translation>
    </message>
    <message>
        <source>Long bowel graspers</source>
        <translation>Lange Darmfasszangen</translation>
    </message>
    <message>
        <source>Slimmer bowel, narrower pelvis</source>
        <translation>Dünnerer Darm, engeres Becken</translation>
    </message>
    <message>
        <source>Run the bowel hand over hand</source>
        <translation>Darm Hand über Hand durchmustern</translation>
    </message>
    <message>
        <source>Lift the middle of the sigmoid and hold it</source>
        <translation>Mitte des Sigmas anheben und halten</translation>
    </message>
    <message>
        <source>Training limit of this task: four times the jerk of one smooth reach (minimum jerk -5.30, less ln 4)</source>
        <translation>Trainingsgrenzwert dieser Aufgabe: das Vierfache des Rucks einer fließenden Greifbewegung (minimaler Ruck -5,30, abzüglich ln 4)</translation>
    </message>
    <message>
        <source>move to the next grasp in one stroke and let it run out</source>
        <translation>gehen Sie in einem Zug zum nächsten Griff und lassen Sie die Bewegung auslaufen</translation>
    </message>
    <message>
        <source>Human bowel: safe to 329-330 kPa for 10 s (BMJ SIT 2021)</source>
        <translation>Menschlicher Darm: sicher bis 329-330 kPa über 10 s (BMJ SIT 2021)</translation>
    </message>
    <message>
        <source>jaws that crush the bowel wall</source>
        <translation>ein Maul, das die Darmwand zerquetscht</translation>
    </message>
    <message>
        <source>Porcine colon: damage follows the force-time product above 300 N s (Barrie 2018)</source>
        <translation>Schweinekolon: Schäden folgen dem Kraft-Zeit-Produkt oberhalb von 300 N s (Barrie 2018)</translation>
    </message>
    <message>
        <source>jaws that hold so hard for so long that the wall is damaged later</source>
        <translation>ein Maul, das so fest und so lange hält, dass die Wand später Schaden nimmt</translation>
    </message>
    <message>
        <source>Any perforation is a critical error; its force is drawn from 10.3 +/- 2.9 N, human small bowel, 1.5 mm tips</source>
        <translation>Jede Perforation ist ein kritischer Fehler; ihre Kraft wird zufällig aus 10,3 +/- 2,9 N gewählt, menschlicher Dünndarm, Spitzen von 1,5 mm</translation>
    </message>
    <message>
        <source>a hole in the bowel is the worst outcome of this task</source>
        <translation>ein Loch im Darm ist der schlimmste Ausgang dieser Aufgabe</translation>
    </message>
    <message>
        <source>Training limit of this task: one drop is allowed</source>
        <translation>Trainingsgrenzwert dieser Aufgabe: Einmal darf der Darm fallen</translation>
    </message>
    <message>
        <source>open the jaws only when the other hand holds the bowel or it is supported</source>
        <translation>öffnen Sie das Maul erst, wenn die andere Hand den Darm hält oder er aufliegt</translation>
    </message>
    <message>
        <source>bowel let fall may be injured unseen</source>
        <translation>Darm, der fällt, kann unbemerkt verletzt werden</translation>
    </message>
    <message>
        <source>Training limit of this task: the tip is in the image for four fifths of the time</source>
        <translation>Trainingsgrenzwert dieser Aufgabe: Die Spitze ist vier Fünftel der Zeit im Bild</translation>
    </message>
    <message>
        <source>move the camera along the bowel as you run it</source>
        <translation>führen Sie die Kamera beim Durchmustern am Darm entlang</translation>
    </message>
    <message>
        <source>Traction and plane cutting</source>
        <translation>Zug und Schichtpräparation</translation>
    </message>
    <message>
        <source>Every plane of the operation is opened in the same way: one hand applies traction until the loose tissue between two layers opens, the other divides it along the line where it is thinnest. Without enough traction the plane does not open and the blade strays into tissue that must be preserved. With too much, fibres tear ahead of the blade, and torn tissue does not count as cut under traction. Grasp the flap, increase traction until it is in the band, and divide the sheet along the marked line over 100 mm. Regrasp further along when the tissue in front of the blade goes slack.</source>
        <translation>Jede Schicht der Operation wird auf dieselbe Weise eröffnet: Eine Hand übt Zug aus, bis sich das lockere Gewebe zwischen zwei Lagen öffnet, die andere durchtrennt es entlang der Linie, an der es am dünnsten ist. Ohne genügend Zug öffnet sich die Schicht nicht, und die Klinge gerät in Gewebe, das erhalten werden muss. Bei zu viel Zug reißen Fasern vor der Klinge, und gerissenes Gewebe zählt nicht als unter Zug geschnitten. Fassen Sie den Lappen, steigern Sie den Zug, bis er im Zielbereich liegt, und durchtrennen Sie die Membran auf 100 mm entlang der markierten Linie. Fassen Sie weiter vorn nach, wenn das Gewebe vor der Klinge erschlafft.</translation>
    </message>
    <message>
        <source>The sheet divided along 100 mm of its marked line, under traction</source>
        <translation>Die Membran auf 100 mm ihrer markierten Linie durchtrennt, unter Zug</translation>
    </message>
    <message>
        <source>With the left jaws, grasp the edge of the flap opposite the beginning of the line.</source>
        <translation>Fassen Sie mit der linken Fasszange den Rand des Lappens gegenüber dem Anfang der Linie.</translation>
    </message>
    <message>
        <source>Apply traction away from the fixed side and slightly upwards until it is in the band, and keep it there.</source>
        <translation>Üben Sie Zug von der festen Seite weg und leicht nach oben aus, bis er im Zielbereich liegt, und halten Sie ihn dort.</translation>
    </message>
    <message>
        <source>Hold the button of the right hand. With one mouse: make the right hand active (Tab), then hold the left mouse button. With two mice: hold the left button of the right mouse.</source>
        <translation>Halten Sie die Taste der rechten Hand gedrückt. Mit einer Maus: Machen Sie die rechte Hand aktiv (Tab) und halten Sie die linke Maustaste. Mit zwei Mäusen: Halten Sie die linke Taste der rechten Maus.</translation>
    </message>
    <message>
        <source>Press the blade onto the beginning of the line until it breaks through, then follow the line.</source>
        <translation>Drücken Sie die Klinge auf den Anfang der Linie, bis sie durchbricht; folgen Sie dann der Linie.</translation>
    </message>
    <message>
        <source>When the tissue in front of the blade goes slack or too tight, stop and regrasp further along.</source>
        <translation>Wenn das Gewebe vor der Klinge erschlafft oder zu straff wird, halten Sie an und fassen Sie weiter vorn nach.</translation>
    </message>
    <message>
        <source>When the line is divided, open the jaws and withdraw both instruments.</source>
        <translation>Wenn die Linie durchtrennt ist, öffnen Sie das Maul und ziehen Sie beide Instrumente zurück.</translation>
    </message>
    <message>
        <source>Deeper plane</source>
        <translation>Tiefere Schicht</translation>
    </message>
    <message>
        <source>Oblique plane</source>
        <translation>Schräge Schicht</translation>
    </message>
    <message>
        <source>Grasp the flap and apply traction</source>
        <translation>Lappen fassen und Zug ausüben</translation>
    </message>
    <message>
        <source>Divide the sheet along the marked line under traction</source>
        <translation>Membran entlang der markierten Linie unter Zug durchtrennen</translation>
    </message>
    <message>
        <source>Release the flap and withdraw</source>
        <translation>Lappen loslassen und zurückziehen</translation>
    </message>
    <message>
        <source>Training limit of this task: tension in the band for half of the cutting time</source>
        <translation>Trainingsgrenzwert dieser Aufgabe: Spannung im Zielbereich für die Hälfte der Schneidezeit</translation>
    </message>
    <message>
        <source>without traction the plane is not seen and the blade strays</source>
        <translation>ohne Zug ist die Schicht nicht zu sehen, und die Klinge weicht ab</translation>
    </message>
    <message>
        <source>Training limit of this task: tension in the band for half of the divided length; torn fibres count as outside the band</source>
        <translation>Trainingsgrenzwert dieser Aufgabe: Spannung im Zielbereich auf der Hälfte der durchtrennten Länge; gerissene Fasern zählen als außerhalb des Zielbereichs</translation>
    </message>
    <message>
        <source>length divided without traction was divided unseen</source>
        <translation>was ohne Zug durchtrennt wurde, wurde ohne Sicht durchtrennt</translation>
    </message>
    <message>
        <source>Training limit of this task: undivided bridges and torn stretches of at most 3 mm in total</source>
        <translation>Trainingsgrenzwert dieser Aufgabe: undurchtrennte Brücken und gerissene Strecken von insgesamt höchstens 3 mm</translation>
    </message>
    <message>
        <source>bridges that remain are torn later</source>
        <translation>Brücken, die bleiben, reißen später</translation>
    </message>
    <message>
        <source>Training limit of this task: no limit is published for a layer this thin</source>
        <translation>Trainingsgrenzwert dieser Aufgabe: Für eine so dünne Lage ist kein Grenzwert veröffentlicht</translation>
    </message>
    <message>
        <source>a cut on the wrong side reaches what must be preserved</source>
        <translation>ein Schnitt auf der falschen Seite erreicht, was erhalten werden muss</translation>
    </message>
    <message>
        <source>Training limit of this task: the scene's limit for areolar tissue</source>
        <translation>Trainingsgrenzwert dieser Aufgabe: der Grenzwert der Szene für lockeres Bindegewebe</translation>
    </message>
    <message>
        <source>traction that tears tissue</source>
        <translation>Zug, der Gewebe zerreißt</translation>
    </message>
    <message>
        <source>Training limit of this task: about three times the grip that holds the tissue; none is published for it</source>
        <translation>Trainingsgrenzwert dieser Aufgabe: etwa das Dreifache des Griffs, der das Gewebe hält; dafür ist keiner veröffentlicht</translation>
    </message>
    <message>
        <source>close the jaws only until the tissue no longer slips</source>
        <translation>schließen Sie das Maul nur so weit, bis das Gewebe nicht mehr abrutscht</translation>
    </message>
    <message>
        <source>jaws that crush what they hold</source>
        <translation>ein Maul, das zerquetscht, was es hält</translation>
    </message>
    <message>
        <source>keep the blade and the marked line in the image</source>
        <translation>behalten Sie die Klinge und die markierte Linie im Bild</translation>
    </message>
    <message>
        <source>Energy and haemostasis</source>
        <translation>Strom und Blutstillung</translation>
    </message>
    <message>
        <source>Energy divides and seals tissue, and its thermal spread can injure tissue nearby. Ten elastic bands are stretched above a bed. Divide them one after another with the ultrasonic shears: take a band with the left grasper, lift it gently, close the shears on it and hold the pedal down until it is divided. A band that tears is not divided. Three bands carry a vessel, marked red. When such a band is divided, the branch at its root on the bed bleeds, and it bleeds more after strong traction; clip the root beforehand or stop the bleeding at once. A yellow nerve runs below one column of bands: keep the blade at least 2 mm away from it. The exchange button changes the instrument in your right hand: shears, clip applier, suction, hook.</source>
        <translation>Strom durchtrennt und verschließt Gewebe, und seine Wärme kann sich ausbreiten und Gewebe in der Nähe schädigen. Zehn elastische Stränge sind über einem Grund gespannt. Durchtrennen Sie sie nacheinander mit der Ultraschallschere: Fassen Sie einen Strang mit der linken Fasszange, heben Sie ihn behutsam an, schließen Sie die Schere um ihn und halten Sie das Pedal gedrückt, bis er durchtrennt ist. Ein Strang, der reißt, gilt nicht als durchtrennt. Drei Stränge führen ein Gefäß, rot markiert. Wird ein solcher Strang durchtrennt, blutet der Ast an seinem Ansatz auf dem Grund, und nach starkem Zug blutet er stärker; clippen Sie den Ansatz vorher oder stillen Sie die Blutung sofort. Unter einer Reihe von Strängen verläuft ein gelber Nerv: Halten Sie die Klinge mindestens 2 mm von ihm entfernt. Die Wechseltaste wechselt das Instrument in Ihrer rechten Hand: Schere, Clipapplikator, Sauger, Haken.</translation>
    </message>
    <message>
        <source>Ten bands divided, haemostasis of three vessels, the nerve intact</source>
        <translation>Zehn Stränge durchtrennt, Blutstillung an drei Gefäßen, der Nerv unverletzt</translation>
    </message>
    <message>
        <source>Hold each band with the left grasper and lift it a little, away from the nerve.</source>
        <translation>Halten Sie jeden Strang mit der linken Fasszange und heben Sie ihn ein wenig an, vom Nerv weg.</translation>
    </message>
    <message>
        <source>Close the shears on the band, then press the pedal. Release it as soon as the band is divided.</source>
        <translation>Schließen Sie die Schere um den Strang und drücken Sie dann das Pedal. Lassen Sie es los, sobald der Strang durchtrennt ist.</translation>
    </message>
    <message>
        <source>Divide on the side away from the yellow nerve and let the blade cool before it touches anything.</source>
        <translation>Durchtrennen Sie auf der Seite, die dem gelben Nerv abgewandt ist, und lassen Sie die Klinge abkühlen, bevor sie etwas berührt.</translation>
    </message>
    <message>
        <source>If a point on the bed bleeds, change to the clip applier, open its jaws and close them on the point.</source>
        <translation>Wenn eine Stelle auf dem Grund blutet, wechseln Sie zum Clipapplikator, öffnen Sie sein Maul und schließen Sie es über der Stelle.</translation>
    </message>
    <message>
        <source>Use suction when smoke or blood hides the field.</source>
        <translation>Saugen Sie, wenn Rauch oder Blut das Operationsfeld verdeckt.</translation>
    </message>
    <message>
        <source>Deeper bed</source>
        <translation>Tieferer Grund</translation>
    </message>
    <message>
        <source>Divide the bands, stop bleeding, preserve the nerve</source>
        <translation>Stränge durchtrennen, Blutungen stillen, Nerv erhalten</translation>
    </message>
    <message>
        <source>Stop all bleeding</source>
        <translation>Alle Blutungen stillen</translation>
    </message>
    <message>
        <source>Training limit of this task: no traction limit is published for such bands</source>
        <translation>Trainingsgrenzwert dieser Aufgabe: Für solche Stränge ist kein Grenzwert für den Zug veröffentlicht</translation>
    </message>
    <message>
        <source>Training limit of this task: four fifths of the time with energy on in view, on target and 2 mm clear</source>
        <translation>Trainingsgrenzwert dieser Aufgabe: vier Fünftel der Zeit mit Strom im Bild, am Ziel und mit 2 mm Abstand</translation>
    </message>
    <message>
        <source>heat out of view or next to a nerve</source>
        <translation>Hitze außerhalb des Bildes oder neben einem Nerv</translation>
    </message>
    <message>
        <source>Tissue that has received 240 min (CEM43), the usual bound of thermal ablation of soft tissue, is taken as dead</source>
        <translation>Gewebe, das 240 min (CEM43) erhalten hat, die übliche Grenze der thermischen Ablation von Weichgewebe, gilt als abgestorben</translation>
    </message>
    <message>
        <source>heat that kills tissue which was to be kept</source>
        <translation>Hitze, die Gewebe abtötet, das erhalten bleiben sollte</translation>
    </message>
    <message>
        <source>A band torn by traction is not divided, and what it carries is torn with it</source>
        <translation>Ein durch Zug gerissener Strang ist nicht durchtrennt, und was er führt, reißt mit</translation>
    </message>
    <message>
        <source>what is torn bleeds and is not divided</source>
        <translation>was gerissen ist, blutet und ist nicht durchtrennt</translation>
    </message>
    <message>
        <source>Any vessel torn or divided open is a critical error</source>
        <translation>Jedes gerissene oder offen durchtrennte Gefäß ist ein kritischer Fehler</translation>
    </message>
    <message>
        <source>bleeding from a vessel that was not closed</source>
        <translation>Blutung aus einem Gefäß, das nicht verschlossen war</translation>
    </message>
    <message>
        <source>A thermal dose above a CEM43 of 60 min at the marked nerve is a critical error</source>
        <translation>Eine Wärmedosis über einem CEM43 von 60 min am markierten Nerv ist ein kritischer Fehler</translation>
    </message>
    <message>
        <source>loss of the function that the nerve serves</source>
        <translation>Verlust der Funktion, die der Nerv versorgt</translation>
    </message>
    <message>
        <source>Mesorectal dissection, posterior sector</source>
        <translation>Mesorektale Präparation, hinterer Sektor</translation>
    </message>
    <message>
        <source>Behind the rectum and the fat of its mesorectum is a plane of loose white fibres, and behind this plane the presacral fascia with its veins. If the dissection stays in the plane, the specimen is intact and the nerves are preserved. Grasp the rectum and lift it off the sacrum until the fibres are taut; divide them with the hook along the marked line, from the patient's right to the left, level after level down to the levator. Yellow fat in front of the blade means that you are in the mesorectum, grey fascia that you are on the veins. There is a tumour in the wall of the rectum at the second level: stay in the plane next to it. At the end you get a pathology report of your specimen.</source>
        <translation>Hinter dem Rektum und dem Fett seines Mesorektums liegt eine Schicht aus lockeren weißen Fasern, und hinter dieser Schicht die präsakrale Faszie mit ihren Venen. Bleibt die Präparation in der Schicht, ist das Präparat unverletzt, und die Nerven bleiben erhalten. Fassen Sie das Rektum und heben Sie es vom Kreuzbein ab, bis die Fasern straff sind; durchtrennen Sie sie mit dem Haken entlang der markierten Linie, von der rechten zur linken Seite des Patienten, Etage für Etage hinunter bis zum Levator. Gelbes Fett vor der Klinge bedeutet, dass Sie im Mesorektum sind, graue Faszie, dass Sie auf den Venen sind. In der Wand des Rektums liegt auf der zweiten Etage ein Tumor: Bleiben Sie neben ihm in der Schicht. Am Ende erhalten Sie einen Pathologiebericht zu Ihrem Präparat.</translation>
    </message>
    <message>
        <source>The posterior mesorectal plane divided on four levels, the mesorectum intact; a pathology report describes the specimen</source>
        <translation>Die hintere mesorektale Schicht auf vier Etagen durchtrennt, das Mesorektum unverletzt; ein Pathologiebericht beschreibt das Präparat</translation>
    </message>
    <message>
        <source>With the left jaws, grasp the rectum in front of the first level and lift it off the sacrum until the traction is in the band.</source>
        <translation>Fassen Sie mit der linken Fasszange das Rektum vor der ersten Etage und heben Sie es vom Kreuzbein ab, bis der Zug im Zielbereich liegt.</translation>
    </message>
    <message>
        <source>Place the hook on the white fibres at the marked line, then press the pedal and move from right to left in short activations.</source>
        <translation>Setzen Sie den Haken an der markierten Linie auf die weißen Fasern, drücken Sie dann das Pedal und gehen Sie mit kurzen Aktivierungen von rechts nach links.</translation>
    </message>
    <message>
        <source>Go down level after level. When the next fibres are slack, regrasp the rectum further down.</source>
        <translation>Gehen Sie Etage für Etage nach unten. Wenn die nächsten Fasern schlaff sind, fassen Sie das Rektum weiter unten nach.</translation>
    </message>
    <message>
        <source>Stay clear of the veins behind the plane. Use suction when smoke or blood hides the plane, and clip a vein that bleeds.</source>
        <translation>Halten Sie Abstand zu den Venen hinter der Schicht. Saugen Sie, wenn Rauch oder Blut die Schicht verdeckt, und clippen Sie eine blutende Vene.</translation>
    </message>
    <message>
        <source>Near the two nerves divide without energy: hold the button of the right hand, not the pedal. With one mouse: the left mouse button while the right hand is active (Tab). With two mice: the left button of the right mouse.</source>
        <translation>Durchtrennen Sie in der Nähe der beiden Nerven ohne Strom: Halten Sie die Taste der rechten Hand, nicht das Pedal. Mit einer Maus: die linke Maustaste, während die rechte Hand aktiv ist (Tab). Mit zwei Mäusen: die linke Taste der rechten Maus.</translation>
    </message>
    <message>
        <source>When the last level is divided, open the jaws and withdraw both instruments.</source>
        <translation>Wenn die letzte Etage durchtrennt ist, öffnen Sie das Maul und ziehen Sie beide Instrumente zurück.</translation>
    </message>
    <message>
        <source>Normal pelvis</source>
        <translation>Normales Becken</translation>
    </message>
    <message>
        <source>Narrow pelvis</source>
        <translation>Enges Becken</translation>
    </message>
    <message>
        <source>Wide pelvis</source>
        <translation>Weites Becken</translation>
    </message>
    <message>
        <source>Lift the rectum until the plane is taut</source>
        <translation>Rektum anheben, bis die Schicht straff ist</translation>
    </message>
    <message>
        <source>Divide the plane level by level under traction</source>
        <translation>Schicht Etage für Etage unter Zug durchtrennen</translation>
    </message>
    <message>
        <source>Release the rectum and withdraw</source>
        <translation>Rektum loslassen und zurückziehen</translation>
    </message>
    <message>
        <source>Training limit of this task: half of the cut within half a millimetre of the plane</source>
        <translation>Trainingsgrenzwert dieser Aufgabe: die Hälfte des Schnitts höchstens einen halben Millimeter von der Schicht entfernt</translation>
    </message>
    <message>
        <source>Training limit of this task: seven tenths of the time with energy on in view, in the tissue to be divided and 2 mm clear of the nerves</source>
        <translation>Trainingsgrenzwert dieser Aufgabe: sieben Zehntel der Zeit mit Strom im Bild, im zu durchtrennenden Gewebe und mit 2 mm Abstand zu den Nerven</translation>
    </message>
    <message>
        <source>Training limit of this task: sharp dissection of the plane may be cold (Heald 1988, with scissors), but a hook has no edge; cold only next to the nerves</source>
        <translation>Trainingsgrenzwert dieser Aufgabe: Die Schicht darf scharf und kalt präpariert werden (Heald 1988, mit der Schere), aber ein Haken hat keine Schneide; kalt nur neben den Nerven</translation>
    </message>
    <message>
        <source>fibres torn cold carry small vessels that bleed</source>
        <translation>kalt gerissene Fasern führen kleine Gefäße, die bluten</translation>
    </message>
    <message>
        <source>Training limit of this task: a specimen is graded where at least 95 % of the line is divided; what tore is not divided</source>
        <translation>Trainingsgrenzwert dieser Aufgabe: Ein Präparat wird bewertet, wenn mindestens 95 % der Linie durchtrennt sind; was gerissen ist, ist nicht durchtrennt</translation>
    </message>
    <message>
        <source>Quirke: complete (3) or nearly complete (2); an incomplete mesorectum (1) fails</source>
        <translation>Quirke: vollständig (3) oder nahezu vollständig (2); mit unvollständigem Mesorektum (1) nicht bestanden</translation>
    </message>
    <message>
        <source>a specimen that is not complete may leave tumour behind</source>
        <translation>ein nicht vollständiges Präparat kann Tumor zurücklassen</translation>
    </message>
    <message>
        <source>A circumferential margin of 1 mm or less is positive</source>
        <translation>Ein zirkumferenzieller Resektionsrand (CRM) von 1 mm oder weniger ist positiv</translation>
    </message>
    <message>
        <source>a positive margin leaves tumour behind</source>
        <translation>ein positiver Resektionsrand lässt Tumor zurück</translation>
    </message>
    <message>
        <source>Any presacral vein torn or divided open is a critical error</source>
        <translation>Jede gerissene oder offen durchtrennte präsakrale Vene ist ein kritischer Fehler</translation>
    </message>
    <message>
        <source>A hypogastric nerve divided or heated is a critical error</source>
        <translation>Ein durchtrennter oder erhitzter N. hypogastricus ist ein kritischer Fehler</translation>
    </message>
    <message>
        <source>areolar</source>
        <translation>lockeres Bindegewebe</translation>
    </message>
    <message>
        <source>band</source>
        <translation>Strang</translation>
    </message>
    <message>
        <source>bed</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>bowel</source>
        <translation>Darm</translation>
    </message>
    <message>
        <source>cup</source>
        <translation>Becher</translation>
    </message>
    <message>
        <source>fascia</source>
        <translation>Faszie</translation>
    </message>
    <message>
        <source>fat</source>
        <translation>Fett</translation>
    </message>
    <message>
        <source>nerve</source>
        <translation>Nerv</translation>
    </message>
    <message>
        <source>object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>tray</source>
        <translation>Platte</translation>
    </message>
    <message>
        <source>vein</source>
        <translation>Vene</translation>
    </message>
    <message>
        <source>vessel</source>
        <translation>Gefäß</translation>
    </message>
    <message>
        <source>wall</source>
        <translation>Wand</translation>
    </message>
    <message>
        <source>GOALS, laparoscopic skills</source>
        <translation>GOALS, laparoskopische Fertigkeiten</translation>
    </message>
    <message>
        <source>Depth perception</source>
        <translation>Tiefenwahrnehmung</translation>
    </message>
    <message>
        <source>The tip often ends up in front of the target or behind it, and finding it takes long</source>
        <translation>Die Spitze landet oft vor oder hinter dem Ziel, und es zu finden dauert lange</translation>
    </message>
    <message>
        <source>The tip is sometimes too short or too far, and is corrected at once</source>
        <translation>Die Spitze ist manchmal zu kurz oder zu weit und wird sofort korrigiert</translation>
    </message>
    <message>
        <source>The tip arrives where it was aimed at, at the right depth</source>
        <translation>Die Spitze kommt dort an, wohin gezielt wurde, in der richtigen Tiefe</translation>
    </message>
    <message>
        <source>Bimanual dexterity</source>
        <translation>Beidhändiges Geschick</translation>
    </message>
    <message>
        <source>One hand does the work while the other is idle or in the way</source>
        <translation>Eine Hand arbeitet, die andere ruht oder ist im Weg</translation>
    </message>
    <message>
        <source>Both hands work, mostly one after the other</source>
        <translation>Beide Hände arbeiten, meist eine nach der anderen</translation>
    </message>
    <message>
        <source>One hand always prepares what the other does next</source>
        <translation>Eine Hand bereitet stets vor, was die andere als Nächstes tut</translation>
    </message>
    <message>
        <source>Efficiency</source>
        <translation>Effizienz</translation>
    </message>
    <message>
        <source>Many tries with little result; jumps between aims, or repeats what does not work</source>
        <translation>Viele Anläufe mit wenig Ergebnis; springt zwischen Zielen oder wiederholt, was nicht gelingt</translation>
    </message>
    <message>
        <source>Takes time, but each step follows a plan</source>
        <translation>Braucht Zeit, aber jeder Schritt folgt einem Plan</translation>
    </message>
    <message>
        <source>Goes straight through the steps, and tries another approach in good time where one fails</source>
        <translation>Geht geradewegs durch die Schritte und wählt rechtzeitig ein anderes Vorgehen, wo eines nicht gelingt</translation>
    </message>
    <message>
        <source>Tissue handling</source>
        <translation>Umgang mit Gewebe</translation>
    </message>
    <message>
        <source>Tissue tears or bleeds from force that was not needed, or slips out of the jaws again and again</source>
        <translation>Gewebe reißt oder blutet durch unnötige Kraft oder gleitet immer wieder aus den Branchen</translation>
    </message>
    <message>
        <source>A gentle hand with a few lapses: a little bleeding, a grasp lost</source>
        <translation>Eine schonende Hand mit einzelnen Fehlern: etwas Blutung, ein verlorener Griff</translation>
    </message>
    <message>
        <source>Traction suits the tissue; nothing is harmed that could be spared</source>
        <translation>Der Zug passt zum Gewebe; nichts wird verletzt, was geschont werden kann</translation>
    </message>
    <message>
        <source>Autonomy</source>
        <translation>Selbstständigkeit</translation>
    </message>
    <message>
        <source>Does not get to the end of the task, however much is explained</source>
        <translation>Kommt nicht ans Ende der Aufgabe, so viel auch erklärt wird</translation>
    </message>
    <message>
        <source>Gets to the end safely when helped with words at some points</source>
        <translation>Kommt sicher ans Ende, mit mündlicher Hilfe an einigen Stellen</translation>
    </message>
    <message>
        <source>Gets to the end safely without a word of help</source>
        <translation>Kommt sicher ans Ende, ohne ein Wort der Hilfe</translation>
    </message>
    <message>
        <source>OSATS, global rating scale</source>
        <translation>OSATS, globale Beurteilungsskala</translation>
    </message>
    <message>
        <source>Respect for tissue</source>
        <translation>Schonung des Gewebes</translation>
    </message>
    <message>
        <source>Pulls, crushes or tears more than once where a gentle hold would do</source>
        <translation>Zieht, quetscht oder reißt mehrfach, wo ein schonender Griff genügt</translation>
    </message>
    <message>
        <source>Gentle for the most part; a few marks on tissue that could have been avoided</source>
        <translation>Meist schonend; einige vermeidbare Spuren am Gewebe</translation>
    </message>
    <message>
        <source>Gentle throughout; tissue that was not operated on looks untouched</source>
        <translation>Durchgehend schonend; nicht operiertes Gewebe sieht unberührt aus</translation>
    </message>
    <message>
        <source>Time and motion</source>
        <translation>Zeit und Bewegung</translation>
    </message>
    <message>
        <source>The hands move for long stretches without a result</source>
        <translation>Die Hände bewegen sich lange ohne Ergebnis</translation>
    </message>
    <message>
        <source>Makes progress, with detours now and then</source>
        <translation>Kommt voran, mit Umwegen hin und wieder</translation>
    </message>
    <message>
        <source>Every movement has a purpose and a short path</source>
        <translation>Jede Bewegung hat einen Zweck und einen kurzen Weg</translation>
    </message>
    <message>
        <source>Instrument handling</source>
        <translation>Umgang mit Instrumenten</translation>
    </message>
    <message>
        <source>Instruments look like a hindrance: fumbling, stops, unsuitable angles</source>
        <translation>Instrumente wirken wie ein Hindernis: Nesteln, Stocken, ungeeignete Winkel</translation>
    </message>
    <message>
        <source>Instruments do what is wanted, sometimes at the second try</source>
        <translation>Instrumente tun, was gewollt ist, manchmal im zweiten Anlauf</translation>
    </message>
    <message>
        <source>Instruments look like an extension of the hands</source>
        <translation>Instrumente wirken wie eine Verlängerung der Hände</translation>
    </message>
    <message>
        <source>Knowledge of instruments</source>
        <translation>Kenntnis der Instrumente</translation>
    </message>
    <message>
        <source>Asks for unsuitable instruments, or does not know their names and uses</source>
        <translation>Verlangt ungeeignete Instrumente oder kennt Namen und Zweck nicht</translation>
    </message>
    <message>
        <source>Chooses well for the common steps, hesitates at the rarer ones</source>
        <translation>Wählt bei den häufigen Schritten gut, zögert bei den selteneren</translation>
    </message>
    <message>
        <source>Asks for the right instrument in good time, at every step</source>
        <translation>Verlangt bei jedem Schritt rechtzeitig das richtige Instrument</translation>
    </message>
    <message>
        <source>Use of assistants</source>
        <translation>Einsatz der Assistenz</translation>
    </message>
    <message>
        <source>Assistants are idle, or their help gets in the way</source>
        <translation>Die Assistenz ist untätig, oder ihre Hilfe stört</translation>
    </message>
    <message>
        <source>Gives assistants a task at the main steps</source>
        <translation>Gibt der Assistenz bei den wichtigsten Schritten eine Aufgabe</translation>
    </message>
    <message>
        <source>Directs assistants ahead of each step, so that the exposure is always there</source>
        <translation>Leitet die Assistenz vor jedem Schritt an, sodass die Darstellung immer steht</translation>
    </message>
    <message>
        <source>Flow of operation and forward planning</source>
        <translation>Ablauf der Operation und Vorausplanung</translation>
    </message>
    <message>
        <source>Interrupts the work again and again to decide what comes next</source>
        <translation>Unterbricht die Arbeit immer wieder, um zu entscheiden, was als Nächstes kommt</translation>
    </message>
    <message>
        <source>Works steadily through the routine parts, pauses at the difficult ones</source>
        <translation>Arbeitet stetig durch die üblichen Teile, hält bei den schwierigen inne</translation>
    </message>
    <message>
        <source>One step prepares the next; there are no gaps</source>
        <translation>Ein Schritt bereitet den nächsten vor; es gibt keine Lücken</translation>
    </message>
    <message>
        <source>Knowledge of the procedure</source>
        <translation>Kenntnis des Eingriffs</translation>
    </message>
    <message>
        <source>Has to be led through most steps</source>
        <translation>Muss durch die meisten Schritte geführt werden</translation>
    </message>
    <message>
        <source>Does the main steps in the right order, misses details</source>
        <translation>Führt die wichtigsten Schritte in der richtigen Reihenfolge aus, lässt Einzelheiten aus</translation>
    </message>
    <message>
        <source>Does all steps in the right order and can say why</source>
        <translation>Führt alle Schritte in der richtigen Reihenfolge aus und kann sie begründen</translation>
    </message>
    <message>
        <source>GAS, steps of a laparoscopic colorectal resection</source>
        <translation>GAS, laparoskopische kolorektale Resektion</translation>
    </message>
    <message>
        <source>Theatre set-up</source>
        <translation>Vorbereitung des Operationssaals</translation>
    </message>
    <message>
        <source>Exposure of the operating field</source>
        <translation>Darstellung des Operationsfelds</translation>
    </message>
    <message>
        <source>Dissection of the vascular pedicle</source>
        <translation>Präparation des Gefäßstiels</translation>
    </message>
    <message>
        <source>Mobilisation of the colon</source>
        <translation>Mobilisation des Kolons</translation>
    </message>
    <message>
        <source>Mobilisation of the splenic or hepatic flexure</source>
        <translation>Mobilisation der linken oder rechten Kolonflexur</translation>
    </message>
    <message>
        <source>Mesorectal dissection</source>
        <translation>Mesorektale Dissektion</translation>
    </message>
    <message>
        <source>Transection and extraction of the specimen</source>
        <translation>Durchtrennung und Bergung des Präparats</translation>
    </message>
    <message>
        <source>Anastomosis</source>
        <translation>Anastomose</translation>
    </message>
    <message>
        <source>The trainee could not do this step; somebody else did it</source>
        <translation>Die Person konnte diesen Schritt nicht ausführen; jemand anderes hat es getan</translation>
    </message>
    <message>
        <source>The trainee did part of it; somebody else did the rest</source>
        <translation>Die Person hat einen Teil ausgeführt, jemand anderes den Rest</translation>
    </message>
    <message>
        <source>The trainee did it with much verbal support</source>
        <translation>Die Person hat es mit viel mündlicher Unterstützung ausgeführt</translation>
    </message>
    <message>
        <source>The trainee did it with little verbal support</source>
        <translation>Die Person hat es mit wenig mündlicher Unterstützung ausgeführt</translation>
    </message>
    <message>
        <source>The trainee did it safely, without help</source>
        <translation>Die Person hat es sicher und ohne Hilfe ausgeführt</translation>
    </message>
    <message>
        <source>The trainee did it as an expert would</source>
        <translation>Die Person hat es ausgeführt, wie es erfahrene Operierende tun</translation>
    </message>
    <message>
        <source>JIGSAWS kinematics (da Vinci robot, suturing, knot tying, needle passing)</source>
        <translation>JIGSAWS-Kinematik (Da-Vinci-Roboter, Nähen, Knoten, Nadel durchführen)</translation>
    </message>
    <message>
        <source>ROSMA kinematics (da Vinci Research Kit, pea on a peg, post and sleeve, wire chaser)</source>
        <translation>ROSMA-Kinematik (Da Vinci Research Kit, Erbse auf Stift, Hülse auf Pfosten, heißer Draht)</translation>
    </message>
    <message>
        <source>PerkTutor transform recording (3D Slicer, tracked tools)</source>
        <translation>PerkTutor-Aufzeichnung von Transformationen (3D Slicer, getrackte Werkzeuge)</translation>
    </message>
    <message>
        <source>synthetic operators, seeds 1000-1999</source>
        <translation>simulierte Operateure, Startwerte 1000-1999</translation>
    </message>
    <message>
        <source>synthetic operators through a model of mouse and keyboard, seeds 1000-1999</source>
        <translation>simulierte Operateure mit einem Modell von Maus und Tastatur, Startwerte 1000-1999</translation>
    </message>
    <message>
        <source>synthetic operators through a model of tracked instruments, seeds 1000-1999</source>
        <translation>simulierte Operateure mit einem Modell von Instrumenten mit Tracking, Startwerte 1000-1999</translation>
    </message>
    <message>
        <source>synthetic operators, stored attempts</source>
        <translation>simulierte Operateure, gespeicherte Versuche</translation>
    </message>
    <message>
        <source>experts of this site</source>
        <translation>Experten dieses Standorts</translation>
    </message>
</context>
</TS>
