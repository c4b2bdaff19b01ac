<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
  <context>
    <name>Sens</name>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>(none)</source>
      <translation>(keine)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>+ run</source>
      <translation>+ Lauf</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>+ sensor</source>
      <translation>+ Sensor</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>+ tool</source>
      <translation>+ Werkzeug</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>, from repeats {pure} µm</source>
      <translation>, aus Wiederholungen {pure} µm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>, stated {stated} µm</source>
      <translation>, angegeben {stated} µm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>3-D error of readings that took no part in the fit, µm</source>
      <translation>Räumlicher Fehler der nicht angepassten Messwerte, µm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>3-D rms of readings that took no part in the fit: declared → with the effects</source>
      <translation>Räumlicher Effektivwert der nicht angepassten Messwerte: angegeben → mit den Effekten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>95 % interval of the held-out rms: {a} … {b} µm before, {c} … {d} µm after.</source>
      <translation>95-%-Bereich des Effektivwerts zurückgehaltener Werte: {a} … {b} µm vorher, {c} … {d} µm nachher.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>95 % of all errors below</source>
      <translation>95 % aller Abweichungen unter</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>95 % of all errors below {before} → {after} µm.</source>
      <translation>95 % aller Abweichungen unter {before} → {after} µm.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>95 % of all parts below {value} µm</source>
      <translation>95 % aller Werkstücke unter {value} µm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>A FreeCAD process ended without an answer; the report view may say why.</source>
      <translation>Ein FreeCAD-Prozess endete ohne Antwort; die Ausgabeansicht nennt vielleicht den Grund.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>A fleet of machines</source>
      <translation>Ein Maschinenpark</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>A machine that goes 3 µm too far has an error of +3 µm and a compensation of −3 µm</source>
      <translation>Eine Maschine, die 3 µm zu weit fährt, hat den Fehler +3 µm und die Kompensation −3 µm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_motion.py" />
      <source>A swing between the ends, or as fitted along a path or over readings</source>
      <translation>Schwingen zwischen den Enden, oder wie angepasst am Weg oder über Messwerten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_jog.py" />
      <source>Abbe offset / {unit}</source>
      <translation>Abbe-Abstand / {unit}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Abbe offset here: {offset}</source>
      <translation>Abbe-Abstand hier: {offset}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/pointers.py" />
      <source>Abbe offset {name}: {length}</source>
      <translation>Abbe-Abstand {name}: {length}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Add</source>
      <translation>Hinzufügen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Add effects</source>
      <translation>Effekte hinzufügen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Adds the selected parts</source>
      <translation>Fügt die gewählten Teile hinzu</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>After</source>
      <translation>Danach</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trial.py" />
      <source>All axes</source>
      <translation>Alle Achsen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_jog.py" />
      <source>All axes to 0</source>
      <translation>Alle Achsen auf 0</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>All but the tool</source>
      <translation>Alle außer dem Werkzeug</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>All errors</source>
      <translation>Alle Abweichungen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Allocate</source>
      <translation>Verteilen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Allocate tolerances</source>
      <translation>Toleranzen verteilen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Allocating {n} tolerances</source>
      <translation>{n} Toleranzen werden verteilt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>Allowed</source>
      <translation>Zulässig</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_motion.py" />
      <source>Along the tool path</source>
      <translation>Am Werkzeugweg</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>An effect of {size} µm rms is found (median of those that could be).</source>
      <translation>Ein Effekt von {size} µm (Effektivwert) wird gefunden (Median der möglichen).</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Angles in</source>
      <translation>Winkel in</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Angles, and those of new tolerance tables</source>
      <translation>Winkel, auch in neuen Toleranztabellen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/command.py" />
      <source>Another panel is open. Close it first.</source>
      <translation>Ein anderes Fenster ist offen. Bitte zuerst schließen.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/proposal_note.py" />
      <source>Answer by a click</source>
      <translation>Mit einem Klick antworten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Apply</source>
      <translation>Anwenden</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Apply what-if</source>
      <translation>Was-wäre-wenn anwenden</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/residuals.py" />
      <source>Arrows {times} times as long as the error</source>
      <translation>Pfeile {times}-mal so lang wie der Fehler</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_assembly.py" />
      <source>Assembly</source>
      <translation>Baugruppe</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>At a random place of the workspace of a random machine within the tolerances</source>
      <translation>An einem zufälligen Ort im Arbeitsraum einer zufälligen Maschine innerhalb der Toleranzen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>At {positions} {unit}</source>
      <translation>Bei {positions} {unit}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Automatic</source>
      <translation>Automatisch</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/sources.py" />
      <source>Back to the default</source>
      <translation>Zurück zur Vorgabe</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/bars.py" />
      <source>Bar: share of the component in the variance. Below: the shares of its errors, which add to it.</source>
      <translation>Balken: Anteil der Komponente an der Varianz. Darunter: die Anteile ihrer Abweichungen, die zusammen ihn ergeben.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>Bed</source>
      <translation>Bett</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Before/after</source>
      <translation>Vorher/nachher</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/first_steps.py" />
      <source>Begin with Sens &gt; Example Machine, or Machine from Selection… on your own parts</source>
      <translation>Mit Sens &gt; Beispielmaschine beginnen, oder mit „Maschine aus Auswahl…“ auf eigenen Teilen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/first_steps.py" />
      <source>Begin with a machine</source>
      <translation>Mit einer Maschine beginnen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>Best places</source>
      <translation>Beste Orte</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>Better</source>
      <translation>Besser</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/live.py" />
      <source>Cancel</source>
      <translation>Abbrechen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Cancelled. Run… with the same folder goes on from there.</source>
      <translation>Abgebrochen. Starten… mit demselben Ordner fährt dort fort.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/messages.py" />
      <source>Cancelled; nothing was changed</source>
      <translation>Abgebrochen; nichts wurde geändert</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Catalogue</source>
      <translation>Katalog</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Cells of spreadsheets and properties: FreeCAD recomputes each variant</source>
      <translation>Zellen von Tabellen und Eigenschaften: FreeCAD berechnet jede Variante neu</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Chance by noise alone</source>
      <translation>Zufall durch Rauschen allein</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Change</source>
      <translation>Änderung</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/scenarios.py" />
      <source>Changes</source>
      <translation>Änderungen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Check on the machine</source>
      <translation>An der Maschine zu prüfen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>Choose a row under Best places: a slope says which way, not how far.</source>
      <translation>Eine Zeile unter Beste Orte wählen: Eine Steigung sagt, wohin, aber nicht, wie weit.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Choose …</source>
      <translation>Wählen …</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Cividis (blue to yellow)</source>
      <translation>Cividis (blau bis gelb)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Clear</source>
      <translation>Leeren</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/proposal_note.py" />
      <source>Click it in the 3D view or the tree.</source>
      <translation>Klicken Sie es in der 3D-Ansicht oder im Baum an.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_jog.py" />
      <source>Click the place in the 3D view first.</source>
      <translation>Klicken Sie zuerst die Stelle in der 3D-Ansicht an.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Click: the parts of the component light up. Double click: its motion</source>
      <translation>Klick: die Teile der Komponente leuchten auf. Doppelklick: ihre Bewegung</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_jog.py" />
      <source>Colour by the indices at this position</source>
      <translation>Nach den Indizes an dieser Position färben</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Colour map</source>
      <translation>Farbtafel</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Colours and legend of new results</source>
      <translation>Farben und Legende neuer Ergebnisse</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>Column</source>
      <translation>Spalte</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Compensated</source>
      <translation>Kompensiert</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tables.py" />
      <source>Compensation tables of {name}</source>
      <translation>Kompensationstabellen von {name}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/ranking.py" />
      <source>Component</source>
      <translation>Komponente</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Components</source>
      <translation>Komponenten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Compute</source>
      <translation>Berechnen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Compute again</source>
      <translation>Neu berechnen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Computes every variant; asks for the folder of the files</source>
      <translation>Berechnet jede Variante; fragt nach dem Ordner der Dateien</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Computes the indices of the machine as it is now</source>
      <translation>Berechnet die Indizes der Maschine, wie sie jetzt ist</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Computes the machine in many variants and shows which of them are best.</source>
      <translation>Berechnet die Maschine in vielen Varianten und zeigt, welche die besten sind.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Computing</source>
      <translation>Berechnung</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/live.py" />
      <source>Computing the indices at {n} positions</source>
      <translation>Berechne die Indizes an {n} Positionen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Computing {n} variants</source>
      <translation>{n} Varianten werden berechnet</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Condition</source>
      <translation>Kondition</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>Contribution</source>
      <translation>Beitrag</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>Contribution to Y; the contributions add to 1</source>
      <translation>Beitrag zu Y; die Beiträge ergeben zusammen 1</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/copying.py" />
      <source>Copy</source>
      <translation>Kopieren</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Correct it, or press Cancel.</source>
      <translation>Bitte berichtigen oder Abbrechen drücken.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Correcting the program</source>
      <translation>Das Programm wird korrigiert</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Correlated tolerances</source>
      <translation>Korrelierte Toleranzen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Cost</source>
      <translation>Kosten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Cost {cost}; nothing cheaper than {bound} meets the target.</source>
      <translation>Kosten {cost}; nichts unter {bound} erreicht das Ziel.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Covariance</source>
      <translation>Kovarianz</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Covariance of errors</source>
      <translation>Kovarianz von Abweichungen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Declare</source>
      <translation>Festlegen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Declare source</source>
      <translation>Quelle festlegen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/residuals.py" />
      <source>Declared errors corrected</source>
      <translation>Angesetzte Fehler korrigiert</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Declared errors that moved when the effects joined</source>
      <translation>Angesetzte Fehler, die sich mit den Effekten verschoben haben</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Defaults</source>
      <translation>Vorgaben</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Design</source>
      <translation>Versuchsplan</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Direction from</source>
      <translation>Richtung aus</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Direction: {vector} ({source})</source>
      <translation>Richtung: {vector} ({source})</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Directions of rails, screws and long edges, the longest first</source>
      <translation>Richtungen von Schienen, Spindeln und langen Kanten, die längsten zuerst</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Distribution</source>
      <translation>Verteilung</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/scenarios.py" />
      <source>Double click: try it again. Delete: remove it from the list</source>
      <translation>Doppelklick: wieder versuchen. Entf: aus der Liste nehmen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Driven by</source>
      <translation>Getrieben von</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_effect.py" />
      <source>Driver</source>
      <translation>Treiber</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Each error keeps its own tolerance besides</source>
      <translation>Jede Abweichung behält dazu ihre Toleranz</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Each point: the value that a reading asks of the component when everything else is taken away.</source>
      <translation>Jeder Punkt: der Wert, den ein Messwert von der Komponente verlangt, wenn alles andere abgezogen ist.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Edit machine</source>
      <translation>Maschine bearbeiten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Effect</source>
      <translation>Effekt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_effect.py" />
      <source>Effect on or off</source>
      <translation>Effekt ein oder aus</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Effects</source>
      <translation>Effekte</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Empties the fields for another source</source>
      <translation>Leert die Felder für eine weitere Quelle</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/ranking.py" />
      <source>Error</source>
      <translation>Abweichung</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Error across the face, + outwards</source>
      <translation>Fehler quer zur Fläche, + nach außen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/analysis.py" />
      <source>Error map</source>
      <translation>Fehlerkarte</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Error on readings that took no part in the fit, µm</source>
      <translation>Fehler der nicht angepassten Messwerte, µm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Error that remains</source>
      <translation>Verbleibender Fehler</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Error, µm</source>
      <translation>Abweichung, µm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Errors</source>
      <translation>Abweichungen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>Errors of random machines</source>
      <translation>Abweichungen zufälliger Maschinen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Errors that come from one cause follow a source: one rail gives straightness and pitch, one temperature lengthens three scales.</source>
      <translation>Abweichungen mit einer gemeinsamen Ursache folgen einer Quelle: Eine Schiene gibt Geradheit und Nicken, eine Temperatur längt drei Maßstäbe.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>Every point at its best place when all of them move; click to see</source>
      <translation>Jeder Punkt an seinem besten Ort, wenn alle verschoben werden; ein Klick zeigt es</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_motion.py" />
      <source>Exaggeration</source>
      <translation>Überhöhung</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Expected error</source>
      <translation>Erwarteter Fehler</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/errormap.py" />
      <source>Expected error √(E[Y]² + V(Y))</source>
      <translation>Erwartete Abweichung √(E[Y]² + V(Y))</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/errormap.py" />
      <source>Expected error √E[Y]</source>
      <translation>Erwarteter Fehler √E[Y]</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Export tolerances</source>
      <translation>Toleranzen ausgeben</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Export…</source>
      <translation>Ausgeben…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Factor</source>
      <translation>Faktor</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>False names</source>
      <translation>Falsche Namen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Feature</source>
      <translation>Merkmal</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Features that exceed it are marked; 0: no limit</source>
      <translation>Merkmale darüber werden markiert; 0: keine Grenze</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>Figure</source>
      <translation>Kenngröße</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>Figures</source>
      <translation>Kenngrößen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Findings</source>
      <translation>Befunde</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Finds the cheapest tolerances that meet the target.</source>
      <translation>Findet die billigsten Toleranzen, die das Ziel erreichen.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>First</source>
      <translation>Erster</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>First-order index S of the component</source>
      <translation>Index erster Ordnung S der Komponente</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>First-order index, mean over the positions</source>
      <translation>Index erster Ordnung, Mittel über die Positionen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/ranking.py" />
      <source>First-order index: the share of the variance that the error has by itself</source>
      <translation>Index erster Ordnung: der Anteil an der Varianz, den die Abweichung allein hat</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Fit</source>
      <translation>Anpassung</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Fit of the declared errors alone</source>
      <translation>Anpassung der angesetzten Fehler allein</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Fits the view to the residuals</source>
      <translation>Passt die Ansicht an die Residuen an</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Fitting the declared errors</source>
      <translation>Angesetzte Fehler werden angepasst</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tables.py" />
      <source>Folder for the compensation tables</source>
      <translation>Ordner für die Kompensationstabellen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_motion.py" />
      <source>Folder for the pictures</source>
      <translation>Ordner für die Bilder</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/export.py" />
      <source>Folder for the report</source>
      <translation>Ordner für den Bericht</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Folder for the trace</source>
      <translation>Ordner für die Ursachensuche</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Folder for the variants</source>
      <translation>Ordner für die Varianten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Folder of the fleet</source>
      <translation>Ordner des Maschinenparks</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Folder…</source>
      <translation>Ordner…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tables.py" />
      <source>Format</source>
      <translation>Format</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Found again in half-samples</source>
      <translation>In halben Stichproben wiedergefunden</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>FreeCAD processes that compute variants beside each other</source>
      <translation>FreeCAD-Prozesse, die nebeneinander Varianten berechnen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>From</source>
      <translation>Von</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>From 0 to 1, so that every machine has the same colours</source>
      <translation>Von 0 bis 1, damit alle Maschinen dieselben Farben haben</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>From 0 to just above the largest index</source>
      <translation>Von 0 bis knapp über den größten Index</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>From 0 to just above the largest index; otherwise the range sticks</source>
      <translation>Von 0 bis knapp über den größten Index; sonst bleibt der Bereich stehen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_motion.py" />
      <source>From a tenth to ten times of what fits the view</source>
      <translation>Von einem Zehntel bis zum Zehnfachen dessen, was in die Ansicht passt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>From file…</source>
      <translation>Aus Datei…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>General</source>
      <translation>Allgemein</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Gives every part its own colours back</source>
      <translation>Gibt jedem Teil seine eigenen Farben zurück</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Gives the machine its former tolerances back</source>
      <translation>Gibt der Maschine ihre früheren Toleranzen zurück</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Gives the selected errors the limits ± this value</source>
      <translation>Gibt den gewählten Abweichungen die Grenzen ± dieser Wert</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Grade</source>
      <translation>Güte</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Grades of guides, screws and scales for straightness and positioning; the rest as before</source>
      <translation>Klassen von Führungen, Gewindetrieben und Maßstäben für Geradheit und Positionierung; alles andere wie zuvor</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Greatest error that is allowed; what is tried passes or fails it</source>
      <translation>Größter zulässiger Fehler; der Versuch hält ihn ein oder nicht</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Grid, positions per axis</source>
      <translation>Gitter, Positionen je Achse</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Gross outliers</source>
      <translation>Grobe Ausreißer</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Gross outliers, left out</source>
      <translation>Grobe Ausreißer, weggelassen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/guide.py" />
      <source>Guide of Sens Workbench</source>
      <translation>Anleitung zu Sens Workbench</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_assembly.py" />
      <source>Held by nothing, left out: {names}</source>
      <translation>Von nichts gehalten, ausgelassen: {names}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Hidden by the declared errors in this plan</source>
      <translation>In diesem Plan von angesetzten Fehlern verdeckt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Hides the machine while the panel is open</source>
      <translation>Blendet die Maschine aus, solange das Fenster offen ist</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Holds a folder for each machine, with machine.json and measured.csv</source>
      <translation>Enthält einen Ordner je Maschine mit machine.json und measured.csv</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_jog.py" />
      <source>Home</source>
      <translation>Nullpunkt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>How far a point may be moved from where it is; the view shows this box</source>
      <translation>Wie weit ein Punkt von seinem Ort verschoben werden darf; die Ansicht zeigt diesen Kasten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>How it is shown</source>
      <translation>Wie es gezeigt wird</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>How much larger than it is the error is drawn; left: not at all</source>
      <translation>Wie viel größer der Fehler gezeichnet wird, als er ist; links: gar nicht</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>How the largest share of the feature moves the machine</source>
      <translation>Wie der größte Anteil des Merkmals die Maschine bewegt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Ideal part beside</source>
      <translation>Ideales Teil daneben</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>Import readings</source>
      <translation>Messwerte importieren</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Import tolerances</source>
      <translation>Toleranzen einlesen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>Import {name}</source>
      <translation>{name} importieren</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Import…</source>
      <translation>Einlesen…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_jog.py" />
      <source>Jog</source>
      <translation>Verfahren</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_jog.py" />
      <source>Jog {name}</source>
      <translation>{name} verfahren</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>Judged</source>
      <translation>Urteil</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Judges the faces that the tool path cuts</source>
      <translation>Beurteilt die Flächen, die der Werkzeugweg schneidet</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Judging the faces that the tool path cuts</source>
      <translation>Die Flächen, die der Werkzeugweg schneidet, werden beurteilt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Keep</source>
      <translation>Merken</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Keeps what is tried in a list, to compare it with others</source>
      <translation>Merkt sich den Versuch in einer Liste, zum Vergleich mit anderen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/scenarios.py" />
      <source>Kept</source>
      <translation>Gemerkt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>Largest total index Sᵀ of the component</source>
      <translation>Größter totaler Index Sᵀ der Komponente</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Latin hypercube</source>
      <translation>Latin Hypercube</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Law</source>
      <translation>Verteilung</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/proposal_note.py" />
      <source>Leaves the question open</source>
      <translation>Lässt die Frage offen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Legend</source>
      <translation>Legende</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Lets the errors follow the source, one undo step</source>
      <translation>Lässt die Abweichungen der Quelle folgen, ein Rückgängig-Schritt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Limit</source>
      <translation>Grenze</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>Limits of the error</source>
      <translation>Grenzen der Abweichung</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Limits of the source, a pure number; each error is its factor times it</source>
      <translation>Grenzen der Quelle, einer reinen Zahl; jede Abweichung ist ihr Faktor mal diese Zahl</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Line</source>
      <translation>Zeile</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Look of the result</source>
      <translation>Aussehen des Ergebnisses</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/proposal_note.py" />
      <source>Looking at shapes: %p %</source>
      <translation>Formen werden untersucht: %p %</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>Looking at the plan</source>
      <translation>Der Plan wird geprüft</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Lower</source>
      <translation>Untere</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Lower left</source>
      <translation>Unten links</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Lower right</source>
      <translation>Unten rechts</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/examples.py" />
      <source>Machine</source>
      <translation>Maschine</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_assembly.py" />
      <source>Machine from assembly</source>
      <translation>Maschine aus Baugruppe</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Machine from selection</source>
      <translation>Maschine aus Auswahl</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Machines</source>
      <translation>Maschinen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Magma (black to pale yellow)</source>
      <translation>Magma (schwarz bis blassgelb)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Makes the found effects objects under their bodies, one undo step</source>
      <translation>Macht die gefundenen Effekte zu Objekten unter ihren Körpern, ein Rückgängig-Schritt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/ranking.py" />
      <source>Meaning</source>
      <translation>Bedeutung</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Measure {name} further: it holds {part} % of what remains uncertain. rms of that: {rms} µm.</source>
      <translation>{name} weiter messen: hier liegen {part} % dessen, was unsicher bleibt. Effektivwert davon: {rms} µm.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>Median</source>
      <translation>Median</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Median, µm</source>
      <translation>Median, µm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_repair.py" />
      <source>Mends every row with a tick, as one undo step</source>
      <translation>Repariert jede Zeile mit Häkchen, als ein einziger Rückgängig-Schritt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_motion.py" />
      <source>Motion of {name}</source>
      <translation>Bewegung von {name}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>Move reference points</source>
      <translation>Bezugspunkte verschieben</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Move the scale of</source>
      <translation>Maßstab verschieben von</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trial.py" />
      <source>Moves one axis after the other to the ends of its travel and back</source>
      <translation>Fährt eine Achse nach der anderen an die Enden ihres Verfahrwegs und zurück</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trial.py" />
      <source>Moves the axis within its travel; it goes back when you let go</source>
      <translation>Bewegt die Achse in ihrem Verfahrweg; beim Loslassen geht sie zurück</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>Moves the chosen reference points, one undo step</source>
      <translation>Verschiebt die gewählten Bezugspunkte, ein Rückgängig-Schritt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Moves the reference point of an axis, where its scale is read, along X, Y, Z</source>
      <translation>Verschiebt den Bezugspunkt einer Achse, an dem ihr Maßstab abgelesen wird, entlang X, Y, Z</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Moves the slice along its axis</source>
      <translation>Verschiebt den Schnitt entlang seiner Achse</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_jog.py" />
      <source>Moves the tool to the place that was clicked in the 3D view</source>
      <translation>Fährt das Werkzeug an die Stelle, die in der 3D-Ansicht angeklickt wurde</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>Moving every point</source>
      <translation>Jeder Punkt wird verschoben</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Name</source>
      <translation>Name</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Needs</source>
      <translation>Braucht</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>New</source>
      <translation>Neu</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Next</source>
      <translation>Weiter</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>No effect is named.</source>
      <translation>Kein Effekt ist benannt.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>No extent, not in the ranking: {effects}</source>
      <translation>Ohne Bereich, nicht in der Rangfolge: {effects}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>No further measurement is needed to tell the findings apart.</source>
      <translation>Es braucht keine weitere Messung, um die Befunde zu unterscheiden.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>No machine in this document. Start with &lt;b&gt;Machine from Selection…&lt;/b&gt; or &lt;b&gt;Example Machine&lt;/b&gt;.</source>
      <translation>Keine Maschine in diesem Dokument. Beginnen Sie mit &lt;b&gt;Maschine aus Auswahl…&lt;/b&gt; oder &lt;b&gt;Beispielmaschine&lt;/b&gt;.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>No result yet: press &lt;b&gt;Compute again&lt;/b&gt;.</source>
      <translation>Noch kein Ergebnis: &lt;b&gt;Neu berechnen&lt;/b&gt; drücken.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>No rival: nothing else that was searched explains as much.</source>
      <translation>Kein Rivale: Nichts anderes, wonach gesucht wurde, erklärt ebenso viel.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>Noise</source>
      <translation>Rauschen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Noise of one reading {noise} µm</source>
      <translation>Rauschen eines Messwerts {noise} µm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/proposal_note.py" />
      <source>Not looked at yet: {names}</source>
      <translation>Noch nicht angesehen: {names}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>Not moved, because it belongs to a part: {names}</source>
      <translation>Nicht verschoben, weil an ein Teil gebunden: {names}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Not square as designed: {pairs}</source>
      <translation>Laut Konstruktion nicht rechtwinklig: {pairs}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Not testable: a column is missing</source>
      <translation>Nicht prüfbar: eine Spalte fehlt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Not told apart by this plan</source>
      <translation>Von diesem Plan nicht unterschieden</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Not traced yet.</source>
      <translation>Noch nicht gesucht.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_repair.py" />
      <source>Nothing is wrong with the machine's objects.</source>
      <translation>An den Objekten der Maschine ist nichts auszusetzen.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Nothing was noticed while reading</source>
      <translation>Beim Lesen fiel nichts auf</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>Noticed while reading:</source>
      <translation>Beim Lesen aufgefallen:</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Now</source>
      <translation>Jetzt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Number of variants</source>
      <translation>Zahl der Varianten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/objective_form.py" />
      <source>Objective</source>
      <translation>Zielgröße</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/messages.py" />
      <source>Objects of this document are damaged: Sens &gt; Repair Machine… mends them.</source>
      <translation>Objekte dieses Dokuments sind beschädigt: Sens &gt; Maschine reparieren… behebt das.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Of the fit</source>
      <translation>Der Anpassung</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>One inch</source>
      <translation>Ein Zoll</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>One millimetre</source>
      <translation>Ein Millimeter</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>One position</source>
      <translation>Eine Position</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/messages.py" />
      <source>Open the folder</source>
      <translation>Ordner öffnen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/messages.py" />
      <source>Open the report</source>
      <translation>Bericht öffnen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Opens the page with all variants and the Pareto front</source>
      <translation>Öffnet die Seite mit allen Varianten und der Pareto-Front</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Open…</source>
      <translation>Öffnen…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>Order of the axes</source>
      <translation>Achsfolge</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/objective_form.py" />
      <source>Orientation of the tool</source>
      <translation>Orientierung des Werkzeugs</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/analysis.py" />
      <source>Original colours</source>
      <translation>Ursprüngliche Farben</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Otherwise the source takes the place of the tolerances of its errors</source>
      <translation>Sonst tritt die Quelle an die Stelle der Toleranzen ihrer Abweichungen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>Out of date</source>
      <translation>Veraltet</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>Out of date: the machine has changed</source>
      <translation>Veraltet: die Maschine wurde geändert</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Out of date: the machine has changed since.</source>
      <translation>Veraltet: die Maschine wurde seither geändert.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/objective_form.py" />
      <source>Output</source>
      <translation>Ausgang</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>Over a grid of {counts} positions</source>
      <translation>Über ein Gitter von {counts} Positionen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_motion.py" />
      <source>Over the readings {name}</source>
      <translation>Über die Messwerte {name}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>Over the workspace, {counts} positions</source>
      <translation>Über den Arbeitsraum, {counts} Positionen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Parameter</source>
      <translation>Parameter</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Parameters</source>
      <translation>Parameter</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Parameters (–: not determined)</source>
      <translation>Parameter (–: nicht bestimmt)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Pareto front</source>
      <translation>Pareto-Front</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Park &amp; Yang's values for all errors</source>
      <translation>Werte von Park &amp; Yang für alle Abweichungen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Part alone</source>
      <translation>Nur das Teil</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Parts</source>
      <translation>Teile</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Parts show</source>
      <translation>Teile zeigen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Per axis</source>
      <translation>Je Achse</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Picture</source>
      <translation>Bild</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Picture…</source>
      <translation>Bild…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>Places</source>
      <translation>Messorte</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>Places of the plan</source>
      <translation>Messorte des Plans</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>Plan the measurement</source>
      <translation>Messung planen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>Point</source>
      <translation>Punkt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Points</source>
      <translation>Punkte</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Position</source>
      <translation>Position</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/objective_form.py" />
      <source>Position of the tool</source>
      <translation>Position des Werkzeugs</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Positions</source>
      <translation>Positionen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Positions of a new machine</source>
      <translation>Positionen einer neuen Maschine</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Positions per axis</source>
      <translation>Positionen je Achse</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/prices.py" />
      <source>Prices of tolerances</source>
      <translation>Preise der Toleranzen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>Probability</source>
      <translation>Wahrscheinlichkeit</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>Programmed positions are those of the tool on the workpiece</source>
      <translation>Programmierte Positionen sind die des Werkzeugs am Werkstück</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>Puts the reference points back</source>
      <translation>Setzt die Bezugspunkte zurück</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Quadrature, positions per axis</source>
      <translation>Quadratur, Positionen je Achse</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Range</source>
      <translation>Bereich</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Rank</source>
      <translation>Rang</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_motion.py" />
      <source>Reading the tool path</source>
      <translation>Der Werkzeugweg wird gelesen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Readings</source>
      <translation>Messwerte</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Reads a covariance: names of errors in the first row and column, µm and µrad</source>
      <translation>Liest eine Kovarianz: Namen der Abweichungen in erster Zeile und Spalte, µm und µrad</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Reads a sweep.json, to change it or to go on where it was cancelled</source>
      <translation>Liest eine sweep.json, um sie zu ändern oder nach einem Abbruch fortzufahren</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Reads prices: symbol, kind, c, k, lower, upper, or grades (see Allocation)</source>
      <translation>Liest Preise: symbol, kind, c, k, lower, upper, oder Güten (siehe Allocation)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Reads tolerances from CSV or JSON</source>
      <translation>Liest Toleranzen aus CSV oder JSON</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Recolour at once when the machine changes</source>
      <translation>Bei Änderung der Maschine sofort umfärben</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_jog.py" />
      <source>Recolours while the axes move; off: the colours of the result stay</source>
      <translation>Färbt während des Verfahrens um; aus: die Farben des Ergebnisses bleiben</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Records</source>
      <translation>Messungen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Reference from</source>
      <translation>Bezug aus</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Reference point: {vector} ({source})</source>
      <translation>Bezugspunkt: {vector} ({source})</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/pointers.py" />
      <source>Reference {name}</source>
      <translation>Bezug {name}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Remove</source>
      <translation>Entfernen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Remove effects</source>
      <translation>Effekte entfernen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Remove source</source>
      <translation>Quelle entfernen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_repair.py" />
      <source>Repair</source>
      <translation>Reparieren</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_repair.py" />
      <source>Repair Machine…</source>
      <translation>Maschine reparieren…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_repair.py" />
      <source>Repair machine</source>
      <translation>Maschine reparieren</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Report</source>
      <translation>Bericht</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Report…</source>
      <translation>Bericht…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/residuals.py" />
      <source>Residual of held-out readings</source>
      <translation>Residuum zurückgehaltener Messwerte</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Residuals</source>
      <translation>Residuen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Residuals as arrows in the workspace, all on one scale</source>
      <translation>Residuen als Pfeile im Arbeitsraum, alle im selben Maßstab</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Result</source>
      <translation>Ergebnis</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Reversed</source>
      <translation>Umgekehrt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Rival</source>
      <translation>Rivale</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>Room</source>
      <translation>Spielraum</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Run…</source>
      <translation>Starten…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/copying.py" />
      <source>Save as CSV…</source>
      <translation>Als CSV speichern…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>Save mapping</source>
      <translation>Zuordnung speichern</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>Save mapping…</source>
      <translation>Zuordnung speichern…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/export.py" />
      <source>Save picture</source>
      <translation>Bild speichern</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_motion.py" />
      <source>Save pictures…</source>
      <translation>Bilder speichern…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/copying.py" />
      <source>Save table</source>
      <translation>Tabelle speichern</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Saves the 3D view with its legend</source>
      <translation>Speichert die 3D-Ansicht mit ihrer Legende</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>Says how large the error of a machine within these tolerances may become, how often it exceeds a limit, and what makes it large.</source>
      <translation>Sagt, wie groß die Abweichung einer Maschine innerhalb dieser Toleranzen werden kann, wie oft sie eine Grenze überschreitet und was sie groß macht.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>Says what a move of each scale, guide block and of the tool by one millimetre is worth, and where each is best within the room.</source>
      <translation>Sagt, was eine Verschiebung jedes Maßstabs, jedes Führungswagens und des Werkzeugs um einen Millimeter wert ist und wo jeder Punkt im Spielraum am besten liegt.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>Says, before anything is measured, how well each declared error will be known.</source>
      <translation>Sagt vor der Messung, wie genau jede angegebene Abweichung bekannt sein wird.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Scatter of one reading, µm</source>
      <translation>Streuung eines Messwerts, µm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Searches for an effect that explains what the declared errors leave</source>
      <translation>Sucht einen Effekt, der erklärt, was die angesetzten Fehler übrig lassen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Searching</source>
      <translation>Suche läuft</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_assembly.py" />
      <source>Select a coordinate system, vertex, edge or face at the tool's tip</source>
      <translation>Ein Koordinatensystem, einen Punkt, eine Kante oder Fläche an der Werkzeugspitze wählen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_repair.py" />
      <source>Sens &gt; Repair Machine… lists all of them and mends them. Their data are kept.</source>
      <translation>Sens &gt; Maschine reparieren… zeigt alle und repariert sie. Ihre Daten bleiben erhalten.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/analysis.py" />
      <source>Sensitivity</source>
      <translation>Sensitivität</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Sensitivity review</source>
      <translation>Sensitivität durchsprechen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Set</source>
      <translation>Setzen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Set ± for selected</source>
      <translation>± für Auswahl setzen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Settings</source>
      <translation>Einstellungen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_effect.py" />
      <source>Shape</source>
      <translation>Form</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>Share</source>
      <translation>Anteil</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Share now</source>
      <translation>Anteil jetzt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Share of false effects among those that stand (false discovery rate)</source>
      <translation>Anteil falscher unter den geltenden Effekten (Falscherkennungsrate)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>Share of the component in the variance</source>
      <translation>Anteil der Komponente an der Varianz</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>Share of the variance, 0 to 1</source>
      <translation>Anteil an der Varianz, 0 bis 1</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Share of the variance; all shares add to 1</source>
      <translation>Anteil an der Varianz; alle zusammen ergeben 1</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Share then</source>
      <translation>Anteil dann</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Shares of the components</source>
      <translation>Anteile der Komponenten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Shares of the components when errors vary together. With the covariance of a fit they say which further measurement helps most.</source>
      <translation>Anteile der Komponenten, wenn Abweichungen gemeinsam schwanken. Mit der Kovarianz einer Anpassung sagen sie, welche weitere Messung am meisten hilft.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Show</source>
      <translation>Zeigen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Show Motion</source>
      <translation>Bewegung zeigen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/ranking.py" />
      <source>Show only: Z, squareness, Spindle …</source>
      <translation>Nur zeigen: Z, Rechtwinkligkeit, Spindel …</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/ranking.py" />
      <source>Shows the errors whose name, component or meaning has these words</source>
      <translation>Zeigt die Abweichungen, deren Name, Komponente oder Bedeutung diese Wörter enthält</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Significant, but not named</source>
      <translation>Signifikant, aber nicht benannt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Size</source>
      <translation>Größe</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/proposal_note.py" />
      <source>Skip</source>
      <translation>Überspringen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Slice at {axis}</source>
      <translation>Schnitt bei {axis}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Sobol' points</source>
      <translation>Sobol-Punkte</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Source</source>
      <translation>Quelle</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Sources</source>
      <translation>Quellen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Sources: {n}. Compute gives their shares in the ranking.</source>
      <translation>Quellen: {n}. Berechnen gibt ihre Anteile in der Rangfolge.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Specification of a sweep</source>
      <translation>Vorgabe einer Variantenrechnung</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>Spindle and tool</source>
      <translation>Spindel und Werkzeug</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/move_arrows.py" />
      <source>Spindle reference</source>
      <translation>Bezugspunkt der Spindel</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Squareness</source>
      <translation>Rechtwinkligkeit</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>Standard uncertainty of one reading</source>
      <translation>Standardunsicherheit eines Messwerts</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>Standard uncertainty of the error's function, rms over the travel</source>
      <translation>Standardunsicherheit der Funktion der Abweichung, Effektivwert über den Verfahrweg</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Start over</source>
      <translation>Von vorn</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Steps</source>
      <translation>Schritte</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/live.py" />
      <source>Stopping…</source>
      <translation>Wird angehalten…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/proposal_note.py" />
      <source>Stops the look and keeps what is known by now</source>
      <translation>Beendet die Untersuchung und behält, was bis jetzt bekannt ist</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Stops; the old result stays</source>
      <translation>Hält an; das alte Ergebnis bleibt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/proposal_note.py" />
      <source>Structure</source>
      <translation>Struktur</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Structure (workpiece → tool, F: bed)</source>
      <translation>Struktur (Werkstück → Werkzeug, F: Bett)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_assembly.py" />
      <source>Structure: {code}</source>
      <translation>Aufbau: {code}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Suggested</source>
      <translation>Vorschläge</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_motion.py" />
      <source>Swing between the ends</source>
      <translation>Schwingen zwischen den Enden</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>Tables (*.csv *.txt *.tsv);;All files (*)</source>
      <translation>Tabellen (*.csv *.txt *.tsv);;Alle Dateien (*)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/sources.py" />
      <source>Take</source>
      <translation>Nehmen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Take selection</source>
      <translation>Auswahl nehmen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>Taken as</source>
      <translation>Gilt als</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_effect.py" />
      <source>Takes part in the errors of the machine</source>
      <translation>Wirkt an den Fehlern der Maschine mit</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/sources.py" />
      <source>Takes the coordinate system, datum, edge, face or part that is selected</source>
      <translation>Nimmt das gewählte Koordinatensystem, Bezugselement, die Kante, Fläche oder das Teil</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Takes the found effects out of the machine again</source>
      <translation>Nimmt die gefundenen Effekte wieder aus der Maschine</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Takes the source away, one undo step; its errors get tolerances of the same width</source>
      <translation>Entfernt die Quelle, ein Rückgängig-Schritt; ihre Abweichungen bekommen Toleranzen derselben Breite</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Takes what the last fit leaves uncertain</source>
      <translation>Nimmt, was die letzte Anpassung unsicher lässt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Target</source>
      <translation>Ziel</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Tells apart: {what}</source>
      <translation>Unterscheidet: {what}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>The document takes this point from a part. Move the part, or choose another point in Edit Machine; the results follow.</source>
      <translation>Das Dokument nimmt diesen Punkt von einem Teil. Das Teil verschieben oder in Maschine bearbeiten einen anderen Punkt wählen; die Ergebnisse folgen.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>The error that the tolerances together may cause</source>
      <translation>Die Abweichung, die alle Toleranzen zusammen verursachen dürfen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>The file does not say what its signs mean. Answer the questions, then import.</source>
      <translation>Die Datei sagt nicht, was ihre Vorzeichen bedeuten. Bitte die Fragen beantworten, dann importieren.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>The file says so in line {line}.</source>
      <translation>Die Datei sagt es in Zeile {line}.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>The first {n} are shown.</source>
      <translation>Gezeigt werden die ersten {n}.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>The fit stopped: {error}. The report view holds the details; please send them in with the readings.</source>
      <translation>Die Anpassung brach ab: {error}. Einzelheiten stehen im Ausgabefenster; bitte senden Sie sie mit den Messwerten ein.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>The largest error that is allowed; each figure passes or fails it</source>
      <translation>Die größte erlaubte Abweichung; jede Kenngröße besteht oder verfehlt sie</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>The machine has changed since this trace. Trace again.</source>
      <translation>Die Maschine hat sich seit dieser Suche geändert. Bitte erneut suchen.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_study.py" />
      <source>The machine has changed since: compute again.</source>
      <translation>Die Maschine hat sich seitdem geändert: neu berechnen.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_assembly.py" />
      <source>The middle of the far end was taken for the side.</source>
      <translation>Statt der Mantelfläche gilt die Mitte des äußeren Endes.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>The order of the axes is how the parts carry each other: rebuild the parts, then choose the structure in Edit Machine.</source>
      <translation>Die Achsfolge ist, wie die Teile einander tragen: die Teile umbauen, dann in Maschine bearbeiten die Struktur wählen.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>The part of all errors, or of all machines, that is below a figure</source>
      <translation>Der Teil aller Abweichungen oder aller Maschinen, der unter einer Kenngröße liegt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>The part of the corrected program, in the same colours; needs fitted errors or effects</source>
      <translation>Das Werkstück des korrigierten Programms in denselben Farben; braucht angepasste Fehler oder Effekte</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>The part that {name} makes</source>
      <translation>Das Werkstück von {name}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>The parts selected in the view or the tree become this component</source>
      <translation>Die in Ansicht oder Baum gewählten Teile werden diese Komponente</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>The positions are</source>
      <translation>Die Positionen sind</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>The readings are</source>
      <translation>Die Messwerte sind</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>The reference points are moved; Undo puts them back</source>
      <translation>Die Bezugspunkte sind verschoben; Rückgängig setzt sie zurück</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>The same for the readings of the fit, µm</source>
      <translation>Dasselbe für die angepassten Messwerte, µm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>The same if every place is measured again in another run</source>
      <translation>Dasselbe, wenn jeder Ort in einem weiteren Lauf noch einmal gemessen wird</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>The same if every place is measured again with a tool of another length</source>
      <translation>Dasselbe, wenn jeder Ort mit einem Werkzeug anderer Länge noch einmal gemessen wird</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>The same if every place is measured in the directions that the plan lacks</source>
      <translation>Dasselbe, wenn jeder Ort auch in den Richtungen gemessen wird, die dem Plan fehlen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>The same would cost least at the tolerance of {symbol}: {price} per µm².</source>
      <translation>Dasselbe wäre am billigsten bei der Toleranz von {symbol}: {price} je µm².</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_assembly.py" />
      <source>The sliders between bed and tool; the others carry the workpiece</source>
      <translation>Die Schieber zwischen Bett und Werkzeug; die übrigen tragen das Werkstück</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>The table has the columns of the readings, without readings</source>
      <translation>Die Tabelle hat die Spalten der Messwerte, ohne Messwerte</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>The tolerances are those of the table; Undo gives the former ones back</source>
      <translation>Die Toleranzen sind die der Tabelle; Rückgängig gibt die früheren zurück</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_assembly.py" />
      <source>The tool is carried by</source>
      <translation>Das Werkzeug wird getragen von</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_assembly.py" />
      <source>The tool reaches {length} past this point.</source>
      <translation>Das Werkzeug reicht {length} über diesen Punkt hinaus.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>The trace stopped: {error}. Nothing was changed. The report view holds the details; please send them in with the readings.</source>
      <translation>Die Suche brach ab: {error}. Nichts wurde geändert. Einzelheiten stehen im Ausgabefenster; bitte senden Sie sie mit den Messwerten ein.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_jog.py" />
      <source>The travel ends {distance} from the clicked point.</source>
      <translation>Der Verfahrweg endet {distance} vor dem angeklickten Punkt.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Then</source>
      <translation>Dann</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>These readings cannot tell it from its rivals:</source>
      <translation>Diese Messwerte können ihn nicht von seinen Rivalen unterscheiden:</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>They are the motion of</source>
      <translation>Sie sind die Bewegung</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>This is the middle of a side, not its end: take it again.</source>
      <translation>Das ist die Mitte einer Mantelfläche, nicht ihr Ende: bitte neu übernehmen.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>This point is at its best place already.</source>
      <translation>Dieser Punkt liegt schon an seinem besten Ort.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Tick the errors that follow the source; double click a factor to change it</source>
      <translation>Abweichungen, die der Quelle folgen, ankreuzen; Doppelklick ändert einen Faktor</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>To</source>
      <translation>Nach</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_jog.py" />
      <source>To clicked point</source>
      <translation>Zum angeklickten Punkt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/ranking.py" />
      <source>Tolerance</source>
      <translation>Toleranz</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Tolerance of the selected errors</source>
      <translation>Toleranz der gewählten Abweichungen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Tolerance of the selected errors, ± this value; Enter sets it</source>
      <translation>Toleranz der gewählten Fehler, ± dieser Wert; Eingabetaste setzt ihn</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Tolerances</source>
      <translation>Toleranzen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Tolerances of {name}</source>
      <translation>Toleranzen von {name}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/move_arrows.py" />
      <source>Tool point</source>
      <translation>Werkzeugpunkt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>Total index Sᵀ of the component</source>
      <translation>Totaler Index Sᵀ der Komponente</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Total index Sᵀ with the effects in the machine</source>
      <translation>Totalindex Sᵀ mit den Effekten in der Maschine</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Total index, largest over the positions</source>
      <translation>Totaler Index, größter über die Positionen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Total index, mean over the positions</source>
      <translation>Totaler Index, Mittel über die Positionen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Total index, weighted by the variance</source>
      <translation>Totaler Index, mit der Varianz gewichtet</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/ranking.py" />
      <source>Total index: the share of the variance with all interactions; they add to more than 1</source>
      <translation>Totaler Index: der Anteil an der Varianz mit allen Wechselwirkungen; zusammen mehr als 1</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Trace</source>
      <translation>Ursache suchen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Trace all</source>
      <translation>Alle untersuchen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Trace of {name}</source>
      <translation>Ursachensuche zu {name}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Traces every record by the same rules: which effect recurs where.</source>
      <translation>Untersucht jede Messung nach denselben Regeln: welcher Effekt wo wiederkehrt.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Tracing {n} records</source>
      <translation>{n} Messungen werden untersucht</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Travel</source>
      <translation>Verfahrweg</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trial.py" />
      <source>Try it</source>
      <translation>Ausprobieren</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Try many designs</source>
      <translation>Viele Entwürfe probieren</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Type a value and select the errors that take it.</source>
      <translation>Einen Wert eingeben und die Abweichungen wählen, die ihn erhalten.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Type limits with decimal point or comma, a unit may follow: 12,5 arcsec.</source>
      <translation>Grenzen mit Dezimalpunkt oder -komma eingeben, eine Einheit darf folgen: 12,5 arcsec.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>U-shaped</source>
      <translation>U-förmig</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>Uncertainties</source>
      <translation>Unsicherheiten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Undo</source>
      <translation>Rückgängig</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/proposal_note.py" />
      <source>Undo answer</source>
      <translation>Antwort zurücknehmen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>Unit</source>
      <translation>Einheit</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Unit in which all angles are shown</source>
      <translation>Einheit, in der alle Winkel gezeigt werden</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Units</source>
      <translation>Einheiten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Up to</source>
      <translation>Bis</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Upper</source>
      <translation>Obere</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/errormap.py" />
      <source>Upper estimate |E[Y]| + 2√V(Y)</source>
      <translation>Obere Schätzung |E[Y]| + 2√V(Y)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/errormap.py" />
      <source>Upper estimate √(E[Y] + 2√V(Y))</source>
      <translation>Obere Schätzung √(E[Y] + 2√V(Y))</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Upper left</source>
      <translation>Oben links</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Upper right</source>
      <translation>Oben rechts</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Usual size</source>
      <translation>Übliche Größe</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Value</source>
      <translation>Wert</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Values</source>
      <translation>Werte</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>Variance-weighted total index Sᵀ</source>
      <translation>Varianzgewichteter totaler Index Sᵀ</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Variants</source>
      <translation>Varianten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Vary</source>
      <translation>Variieren</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Verdict</source>
      <translation>Urteil</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Viridis (purple to yellow)</source>
      <translation>Viridis (violett bis gelb)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/objective_form.py" />
      <source>Weight of each component; 0 leaves it out (a groove does not care along its length)</source>
      <translation>Gewicht jeder Komponente; 0 lässt sie weg (längs einer Nut ist sie gleichgültig)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/objective_form.py" />
      <source>Weights</source>
      <translation>Gewichte</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Were all errors normal, nothing would be cheaper than {bound}.</source>
      <translation>Wären alle Abweichungen normalverteilt, wäre nichts billiger als {bound}.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>What</source>
      <translation>Was</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>What each column of the table is:</source>
      <translation>Was jede Spalte der Tabelle ist:</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>What if</source>
      <translation>Was wäre wenn</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>What is computed for each variant</source>
      <translation>Was für jede Variante berechnet wird</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>What is judged</source>
      <translation>Was beurteilt wird</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>What is left</source>
      <translation>Was übrig bleibt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>What makes it large</source>
      <translation>Was sie groß macht</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>What recurs</source>
      <translation>Was wiederkehrt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>What the declared errors leave depends on {columns}.</source>
      <translation>Was die angesetzten Fehler übrig lassen, hängt ab von {columns}.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/ranking.py" />
      <source>What the error contributes to the variance, (S + Sᵀ)/2: the shares add to 100 %. Work on the largest first</source>
      <translation>Was die Abweichung zur Varianz beiträgt, (S + Sᵀ)/2: die Anteile ergeben 100 %. Zuerst am größten arbeiten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/analysis.py" />
      <source>What the map shows is chosen in the review, under Settings</source>
      <translation>Was die Karte zeigt, wird in der Auswertung unter „Einstellungen“ gewählt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>What the readings mean</source>
      <translation>Was die Messwerte bedeuten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tables.py" />
      <source>What these files hold, and what they cannot:</source>
      <translation>Was diese Dateien enthalten, und was sie nicht können:</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>What to do</source>
      <translation>Was zu tun ist</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>What to measure next</source>
      <translation>Was als Nächstes zu messen ist</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>When a table moves to +X, the tool moves to −X on the workpiece</source>
      <translation>Fährt ein Tisch nach +X, bewegt sich das Werkzeug am Werkstück nach −X</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Where the number stands: joints.Z.point.2, Spreadsheet.reach, Box.Length</source>
      <translation>Wo die Zahl steht: joints.Z.point.2, Spreadsheet.reach, Box.Length</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>Where to move</source>
      <translation>Wohin verschieben</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Who makes it</source>
      <translation>Wer es verursacht</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Why it carries no name</source>
      <translation>Warum es keinen Namen trägt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Why it remains</source>
      <translation>Warum er bleibt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>With the corrected program</source>
      <translation>Mit dem korrigierten Programm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/residuals.py" />
      <source>With the found effects</source>
      <translation>Mit den gefundenen Effekten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Workers</source>
      <translation>Prozesse</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>Workpiece and fixture</source>
      <translation>Werkstück und Vorrichtung</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/move_arrows.py" />
      <source>Workpiece reference</source>
      <translation>Bezugspunkt des Werkstücks</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Workspace, Gauss-Legendre quadrature</source>
      <translation>Arbeitsraum, Gauß-Legendre-Quadratur</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Workspace, regular grid</source>
      <translation>Arbeitsraum, regelmäßiges Gitter</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>Worst place</source>
      <translation>Ungünstigster Ort</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>Worst place: {size}</source>
      <translation>Ungünstigster Ort: {size}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tables.py" />
      <source>Write files…</source>
      <translation>Dateien schreiben…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Writes HTML, JSON and CSV</source>
      <translation>Schreibt HTML, JSON und CSV</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Writes features, shares and pictures of the part</source>
      <translation>Schreibt Merkmale, Anteile und Bilder des Werkstücks</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_motion.py" />
      <source>Writes the motion as an animated GIF and as numbered PNG pictures</source>
      <translation>Schreibt die Bewegung als animiertes GIF und als nummerierte PNG-Bilder</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tables.py" />
      <source>Writes the tables and this statement into a folder</source>
      <translation>Schreibt die Tabellen und diese Aufstellung in einen Ordner</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Writes the tolerances to the machine, one undo step</source>
      <translation>Schreibt die Toleranzen in die Maschine, ein Schritt zum Rückgängigmachen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Writes the tolerances, weights and moved scales to the machine, one undo step</source>
      <translation>Schreibt Toleranzen, Gewichte und verschobene Maßstäbe in die Maschine, ein Rückgängig-Schritt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Writes the tolerances, what other targets cost, and a report</source>
      <translation>Schreibt die Toleranzen, die Kosten anderer Ziele und einen Bericht</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>Writes these choices to a file for the command line's --mapping</source>
      <translation>Schreibt diese Angaben in eine Datei für --mapping der Befehlszeile</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Writes tolerances as CSV or JSON</source>
      <translation>Schreibt Toleranzen als CSV oder JSON</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Writes trace.json, report.html and the augmented machine</source>
      <translation>Schreibt trace.json, report.html und die ergänzte Maschine</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Writes what was found as a page, and as JSON and CSV</source>
      <translation>Schreibt das Ergebnis als Seite sowie als JSON und CSV</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/messages.py" />
      <source>Written to {folder}:</source>
      <translation>Geschrieben nach {folder}:</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/copying.py" />
      <source>Written: {files}</source>
      <translation>Geschrieben: {files}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>X carriage</source>
      <translation>X-Schlitten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>XYFZ: table X on saddle Y; the spindle moves along Z</source>
      <translation>XYFZ: Tisch X auf Sattel Y; die Spindel fährt in Z</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>Y carriage</source>
      <translation>Y-Schlitten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>Y: square of the orientation error of the tool</source>
      <translation>Y: Quadrat des Orientierungsfehlers des Werkzeugs</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>Y: square of the position error of the tool</source>
      <translation>Y: Quadrat des Positionsfehlers des Werkzeugs</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>Z carriage</source>
      <translation>Z-Schlitten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Zoom</source>
      <translation>Zoom</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_assembly.py" />
      <source>a coordinate system named TCP or tool tip, if there is one</source>
      <translation>ein Koordinatensystem namens TCP oder Werkzeugspitze, falls vorhanden</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>a list</source>
      <translation>eine Liste</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>a quarter</source>
      <translation>ein Viertel</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>after</source>
      <translation>nachher</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>also turns what the guide carries</source>
      <translation>dreht auch, was die Führung trägt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>approach along {axis}</source>
      <translation>Anfahrrichtung {axis}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>arc seconds (″)</source>
      <translation>Bogensekunden (″)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>as it is</source>
      <translation>wie sie ist</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>as programmed</source>
      <translation>wie programmiert</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/sources.py" />
      <source>at its centre of mass</source>
      <translation>an seinem Schwerpunkt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/sources.py" />
      <source>at its placement</source>
      <translation>an seiner Platzierung</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>at most</source>
      <translation>höchstens</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>bed</source>
      <translation>Bett</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>before</source>
      <translation>vorher</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>before and after</source>
      <translation>vorher und nachher</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>catalogue, relative costs</source>
      <translation>Katalog, relative Kosten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>cells, properties</source>
      <translation>Zellen, Eigenschaften</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>chosen</source>
      <translation>gewählt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>compensation values: commanded minus actual</source>
      <translation>Kompensationswerte: Soll minus Ist</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>cylindricity</source>
      <translation>Zylindrizität</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>declared</source>
      <translation>angesetzt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>direction of sensing {axis}</source>
      <translation>Messrichtung {axis}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>distance</source>
      <translation>Abstand</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>doubled</source>
      <translation>verdoppelt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>driver, as it is</source>
      <translation>Treiber, unverändert</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>effect as fitted</source>
      <translation>angepasster Effekt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/messages.py" />
      <source>en</source>
      <translation>de</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>error along {axis}</source>
      <translation>Fehler in {axis}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>error of a held-out point, µm</source>
      <translation>Fehler eines zurückgehaltenen Punkts, µm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>errors: actual minus commanded</source>
      <translation>Fehler: Ist minus Soll</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>every combination</source>
      <translation>jede Kombination</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>exceeds its limit</source>
      <translation>überschreitet die Grenze</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/scenarios.py" />
      <source>fails</source>
      <translation>nicht eingehalten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>feed</source>
      <translation>Vorschub</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>fixed value</source>
      <translation>fester Wert</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>flatness</source>
      <translation>Ebenheit</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/pointers.py" />
      <source>for +{name} the table moves to −{name}</source>
      <translation>für +{name} fährt der Tisch nach −{name}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>for example 5 or 10 arcsec</source>
      <translation>zum Beispiel 5 oder 10 arcsec</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>from</source>
      <translation>von</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>from a table</source>
      <translation>aus einer Tabelle</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>frozen</source>
      <translation>eingefroren</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>halved</source>
      <translation>halbiert</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>halving a tolerance doubles its cost</source>
      <translation>die halbe Toleranz kostet doppelt so viel</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>ignored</source>
      <translation>ignoriert</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/sources.py" />
      <source>its local X</source>
      <translation>sein lokales X</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/sources.py" />
      <source>its local Y</source>
      <translation>sein lokales Y</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/sources.py" />
      <source>its local Z</source>
      <translation>sein lokales Z</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>largest</source>
      <translation>größter</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>largest share then: {name}, {value}</source>
      <translation>größter Anteil dann: {name}, {value}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>load</source>
      <translation>Last</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>no folder yet</source>
      <translation>noch kein Ordner</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>no index</source>
      <translation>kein Index</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>none</source>
      <translation>keine</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>none: moves are shown without their worth</source>
      <translation>keine: Verschiebungen stehen ohne ihren Wert</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>none: read a file, or fit readings first</source>
      <translation>keine: eine Datei lesen oder erst Messungen anpassen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>normal (limits ±3σ)</source>
      <translation>normal (Grenzen ±3σ)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>not cut by the path</source>
      <translation>nicht vom Weg geschnitten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>not determined</source>
      <translation>nicht bestimmt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>nothing</source>
      <translation>nichts</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>numbers of the machine</source>
      <translation>Zahlen der Maschine</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>of the fit: what remains uncertain</source>
      <translation>der Anpassung: was unsicher bleibt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>of the table, X and Y counted its way</source>
      <translation>des Tischs, X und Y in seiner Richtung gezählt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>off</source>
      <translation>aus</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>one position</source>
      <translation>eine Stellung</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>p up to {limit} stands; every p comes from {count} exchanges.</source>
      <translation>Es gilt p bis {limit}; jedes p beruht auf {count} Vertauschungen.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>parallelism</source>
      <translation>Parallelität</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/scenarios.py" />
      <source>passes</source>
      <translation>eingehalten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>perpendicularity</source>
      <translation>Rechtwinkligkeit</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>points</source>
      <translation>Punkte</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>position</source>
      <translation>Position</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>position {axis}</source>
      <translation>Position {axis}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>range of the deviation along this body diagonal (ISO 230-6); click to see it</source>
      <translation>Spannweite der Abweichung entlang dieser Raumdiagonale (ISO 230-6); ein Klick zeigt sie</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>range over the workspace of the error along {axis} (ISO 230-1)</source>
      <translation>Spannweite der Abweichung längs {axis} im Arbeitsraum (ISO 230-1)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>reading along its direction</source>
      <translation>Messwert in seiner Richtung</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>readings</source>
      <translation>Messwerte</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>refused</source>
      <translation>abgelehnt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>rivals that these readings cannot tell from it: {n}</source>
      <translation>Rivalen, die diese Messwerte nicht davon unterscheiden: {n}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>rms at the worst place</source>
      <translation>rms am ungünstigsten Ort</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>rms over the workspace</source>
      <translation>rms im Arbeitsraum</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>rms {before} → {after} µm, at the worst place {worst_before} → {worst_after} µm.</source>
      <translation>rms {before} → {after} µm, am ungünstigsten Ort {worst_before} → {worst_after} µm.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>rms {now} µm; best single move: {name}, {then} µm; all but the tool: {all} µm.</source>
      <translation>Effektivwert {now} µm; beste einzelne Verschiebung: {name}, {then} µm; alle außer dem Werkzeug: {all} µm.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>rms, µm</source>
      <translation>rms, µm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>roundness</source>
      <translation>Rundheit</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>run</source>
      <translation>Lauf</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>scale moved</source>
      <translation>Maßstab verschoben</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>scale of {name} moved by {offset}</source>
      <translation>Maßstab von {name} um {offset} verschoben</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/errormap.py" />
      <source>slice at {axis} = {position}</source>
      <translation>Schnitt bei {axis} = {position}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>spindle speed</source>
      <translation>Spindeldrehzahl</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>squareness carried</source>
      <translation>Rechtwinkligkeit wird mitgeführt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>squareness tilts the direction (ISO)</source>
      <translation>Rechtwinkligkeit neigt die Richtung (ISO)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>standard uncertainty</source>
      <translation>Standardunsicherheit</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>straightness</source>
      <translation>Geradheit</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>such as rail of Y</source>
      <translation>etwa Schiene von Y</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>suggested</source>
      <translation>vorgeschlagen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>temperature</source>
      <translation>Temperatur</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_assembly.py" />
      <source>the bed (no slider)</source>
      <translation>dem Bett (kein Schieber)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>the first part</source>
      <translation>das erste Teil</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>the largest of V_X, V_Y and V_Z (ISO 230-1)</source>
      <translation>die größte von V_X, V_Y und V_Z (ISO 230-1)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>the largest of the diagonal deviations (ISO 230-6)</source>
      <translation>die größte der Diagonalabweichungen (ISO 230-6)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>the parts</source>
      <translation>die Teile</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>the table relative to the tool</source>
      <translation>des Tischs gegenüber dem Werkzeug</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>the tool relative to the workpiece</source>
      <translation>des Werkzeugs gegenüber dem Werkstück</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>tilts the motion (ISO 230-1)</source>
      <translation>neigt die Richtung (ISO)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>time</source>
      <translation>Zeit</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>to</source>
      <translation>bis</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>tool</source>
      <translation>Werkzeug</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>tool offset {axis}</source>
      <translation>Werkzeugversatz {axis}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/errormap.py" />
      <source>tool point over the workspace</source>
      <translation>Werkzeugpunkt im Arbeitsraum</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>traced effect</source>
      <translation>gefundener Effekt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>triangular</source>
      <translation>dreieckig</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>truncated normal</source>
      <translation>abgeschnitten normal</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>u</source>
      <translation>u</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>uncertainty</source>
      <translation>Unsicherheit</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>uncertainty of the error along {axis}</source>
      <translation>Unsicherheit der Abweichung entlang {axis}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>uncorrected</source>
      <translation>unkorrigiert</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>uniform</source>
      <translation>gleichverteilt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>variants</source>
      <translation>Varianten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>with effects</source>
      <translation>mit Effekten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>workpiece</source>
      <translation>Werkstück</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>{axis} carriage</source>
      <translation>{axis}-Schlitten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>{axis} is in no column; it stood at</source>
      <translation>{axis} steht in keiner Spalte; sie stand bei</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_repair.py" />
      <source>{count} can be repaired; values that are there are kept.</source>
      <translation>{count} lassen sich reparieren; vorhandene Werte bleiben erhalten.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_repair.py" />
      <source>{count} objects of Sens Workbench in “{name}” are damaged, such as:</source>
      <translation>{count} Objekte von Sens Workbench in „{name}“ sind beschädigt, etwa:</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_repair.py" />
      <source>{count} only you can settle; each row says how.</source>
      <translation>{count} können nur Sie klären; jede Zeile sagt, wie.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_repair.py" />
      <source>{count} repaired. Undo takes it back.</source>
      <translation>{count} repariert. Rückgängig nimmt es zurück.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>{do} (predicted difference {size} µm)</source>
      <translation>{do} (vorhergesagter Unterschied {size} µm)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>{driver}, K from 20 °C</source>
      <translation>{driver}, K ab 20 °C</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_motion.py" />
      <source>{error} moves {body} by {value} {unit}, and the tool by {answer} µm. Shown {times} times as large.</source>
      <translation>{error} bewegt {body} um {value} {unit} und das Werkzeug um {answer} µm. {times}-fach gezeigt.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>{faces} faces are cut. Click a face or a row.</source>
      <translation>{faces} Flächen werden geschnitten. Klicken Sie auf eine Fläche oder Zeile.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>{face}: largest error {value} µm at {place}</source>
      <translation>{face}: größter Fehler {value} µm bei {place}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>{face}: not cut by the path</source>
      <translation>{face}: nicht vom Weg geschnitten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>{file}: {rows} readings at {points} places</source>
      <translation>{file}: {rows} Messwerte an {points} Orten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/messages.py" />
      <source>{folder} holds {files} already. Overwrite?</source>
      <translation>{folder} enthält schon {files}. Überschreiben?</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>{found}. Please answer the questions above.</source>
      <translation>{found}. Bitte die Fragen oben beantworten.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>{level} % of all errors are below &lt;b&gt;{size}&lt;/b&gt;; at the worst place ({place}) {worst}.</source>
      <translation>{level} % aller Abweichungen liegen unter &lt;b&gt;{size}&lt;/b&gt;; am ungünstigsten Ort ({place}) unter {worst}.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>{name} is declared; its share stands in the ranking</source>
      <translation>{name} ist festgelegt; ihr Anteil steht in der Rangfolge</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>{name} makes {part} % of the variance. rms over the workspace: {rms} µm.</source>
      <translation>{name} macht {part} % der Varianz aus. Effektivwert im Arbeitsraum: {rms} µm.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>{name}, lower end</source>
      <translation>{name}, unteres Ende</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>{name}, upper end</source>
      <translation>{name}, oberes Ende</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/move_arrows.py" />
      <source>{name}: best place, {length} away</source>
      <translation>{name}: bester Ort, {length} entfernt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/residuals.py" />
      <source>{name}: rms {rms} µm</source>
      <translation>{name}: Effektivwert {rms} µm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/residuals.py" />
      <source>{name}: rms {rms} µm, largest {largest} µm</source>
      <translation>{name}: Effektivwert {rms} µm, größter {largest} µm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>{n} blocks leave the travel of the machine.</source>
      <translation>{n} Sätze verlassen den Verfahrweg der Maschine.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>{n} changes would make the plan better.</source>
      <translation>{n} Änderungen würden den Plan verbessern.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>{n} errors read.</source>
      <translation>{n} Abweichungen eingelesen.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>{n} machines in {folder}</source>
      <translation>{n} Maschinen in {folder}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>{n} of them are there already</source>
      <translation>{n} davon sind schon vorhanden</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>{n} records, {refused} refused; an effect stands on {some} machines.</source>
      <translation>{n} Messungen, {refused} abgelehnt; an {some} Maschinen gilt ein Effekt.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/copying.py" />
      <source>{n} rows copied</source>
      <translation>{n} Zeilen kopiert</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>{n} variants, {best} on the Pareto front (bold), {refused} refused. Files: {folder}</source>
      <translation>{n} Varianten, {best} auf der Pareto-Front (fett), {refused} abgelehnt. Dateien: {folder}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>{part} % ± {error} of all errors exceed {limit}: the {level} % error {judged}.</source>
      <translation>{part} % ± {error} aller Abweichungen überschreiten {limit}: die {level}-%-Abweichung: {judged}.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>{places} places: {rank} of {parameters} parameters are determined.</source>
      <translation>{places} Messorte: {rank} von {parameters} Parametern sind bestimmt.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>{rank} of {columns} are determined</source>
      <translation>{rank} von {columns} sind bestimmt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>{rms} µm rms, largest {largest} µm</source>
      <translation>{rms} µm Effektivwert, größter {largest} µm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>{rows} at {points} places</source>
      <translation>{rows} an {points} Orten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>{rows} readings at {points} places</source>
      <translation>{rows} Messwerte an {points} Orten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/residuals.py" />
      <source>{shown} of {all} places</source>
      <translation>{shown} von {all} Orten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>{symbol} of {body}, driven by {driver}: {size} µm rms over the readings</source>
      <translation>{symbol} von {body}, getrieben von {driver}: {size} µm Effektivwert über die Messwerte</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/messages.py" />
      <source>{what} stopped: {error}. Nothing was changed. The report view holds the details.</source>
      <translation>{what} brach ab: {error}. Nichts wurde geändert. Einzelheiten stehen im Ausgabefenster.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>± 5 µm or 10 arcsec</source>
      <translation>± 5 µm oder 10 arcsec</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>– please answer –</source>
      <translation>– bitte antworten –</translation>
    </message>
  </context>
  <context>
    <name>Sens_AddEffect</name>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Add Effects</source>
      <translation>Effekte hinzufügen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Adds the found effects to the machine, each under its body</source>
      <translation>Fügt der Maschine die gefundenen Effekte hinzu, jeden unter seinem Körper</translation>
    </message>
  </context>
  <context>
    <name>Sens_Allocate</name>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Allocate Tolerances…</source>
      <translation>Toleranzen verteilen…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Finds the cheapest tolerances that meet a target, and applies them</source>
      <translation>Findet die billigsten Toleranzen für ein Ziel und übernimmt sie</translation>
    </message>
  </context>
  <context>
    <name>Sens_Correlated</name>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Correlated Tolerances…</source>
      <translation>Korrelierte Toleranzen…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Declares errors that come from one cause, and shares for a covariance</source>
      <translation>Legt Abweichungen mit gemeinsamer Ursache fest und zeigt Anteile für eine Kovarianz</translation>
    </message>
  </context>
  <context>
    <name>Sens_EditMachine</name>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Changes chains, carriages, directions, reference points and travel</source>
      <translation>Ändert Ketten, Schlitten, Richtungen, Bezugspunkte und Verfahrwege</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Edit Machine…</source>
      <translation>Maschine bearbeiten…</translation>
    </message>
  </context>
  <context>
    <name>Sens_EditReadings</name>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>Changes what the columns of an imported table are taken for</source>
      <translation>Ändert, wofür die Spalten einer importierten Tabelle gelten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>Columns of the Readings…</source>
      <translation>Spalten der Messwerte…</translation>
    </message>
  </context>
  <context>
    <name>Sens_Effect</name>
    <message>
      <location filename="../../sensworkbench/gui/task_effect.py" />
      <source>Effect…</source>
      <translation>Effekt…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_effect.py" />
      <source>Shows what an effect is, and whether it takes part in the errors</source>
      <translation>Zeigt, was ein Effekt ist und ob er an den Fehlern mitwirkt</translation>
    </message>
  </context>
  <context>
    <name>Sens_ErrorMap</name>
    <message>
      <location filename="../../sensworkbench/gui/analysis.py" />
      <source>Error Map</source>
      <translation>Fehlerkarte</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/analysis.py" />
      <source>Shows the error over the workspace as coloured points or a slice, or hides it</source>
      <translation>Zeigt die Abweichung über dem Arbeitsraum als farbige Punkte oder Schnitt, oder blendet sie aus</translation>
    </message>
  </context>
  <context>
    <name>Sens_Example</name>
    <message>
      <location filename="../../sensworkbench/gui/examples.py" />
      <source>Example Machine</source>
      <translation>Beispielmaschine</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/examples.py" />
      <source>Makes an example machine in an empty or new document</source>
      <translation>Macht eine Beispielmaschine in einem leeren oder neuen Dokument</translation>
    </message>
  </context>
  <context>
    <name>Sens_ExampleFXYZ</name>
    <message>
      <location filename="../../sensworkbench/gui/examples.py" />
      <source>Gantry (FXYZ)</source>
      <translation>Portal (FXYZ)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/examples.py" />
      <source>Makes a gantry machine: the tool carries out all three motions</source>
      <translation>Macht eine Portalmaschine: das Werkzeug führt alle drei Bewegungen aus</translation>
    </message>
  </context>
  <context>
    <name>Sens_ExampleXYFZ</name>
    <message>
      <location filename="../../sensworkbench/gui/examples.py" />
      <source>Makes a machining centre: table on cross slides, spindle on the column</source>
      <translation>Macht ein Bearbeitungszentrum: Tisch auf Kreuzschlitten, Spindel am Ständer</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/examples.py" />
      <source>Vertical Machining Centre (XYFZ)</source>
      <translation>Senkrecht-Bearbeitungszentrum (XYFZ)</translation>
    </message>
  </context>
  <context>
    <name>Sens_ExampleYFXZ</name>
    <message>
      <location filename="../../sensworkbench/gui/examples.py" />
      <source>Makes a travelling-column machine: the table moves along Y</source>
      <translation>Macht eine Fahrständermaschine: der Tisch fährt in Y</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/examples.py" />
      <source>Travelling Column (YFXZ)</source>
      <translation>Fahrständer (YFXZ)</translation>
    </message>
  </context>
  <context>
    <name>Sens_Fit</name>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Fit Declared Errors…</source>
      <translation>Angesetzte Fehler anpassen…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Fits the declared errors to the readings: what they explain, and what the plan cannot tell apart</source>
      <translation>Passt die angesetzten Fehler an die Messwerte an: was sie erklären und was der Plan nicht unterscheidet</translation>
    </message>
  </context>
  <context>
    <name>Sens_Fleet</name>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Fleet…</source>
      <translation>Maschinenpark…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Traces the records of many machines: which effect recurs on which machine</source>
      <translation>Untersucht die Messungen vieler Maschinen: welcher Effekt an welcher Maschine wiederkehrt</translation>
    </message>
  </context>
  <context>
    <name>Sens_Guide</name>
    <message>
      <location filename="../../sensworkbench/gui/guide.py" />
      <source>Guide</source>
      <translation>Anleitung</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/guide.py" />
      <source>Shows the guide; in a panel of Sens Workbench F1 shows the section about it</source>
      <translation>Zeigt die Anleitung (englisch); in einem Fenster von Sens Workbench zeigt F1 den Abschnitt dazu</translation>
    </message>
  </context>
  <context>
    <name>Sens_ImportReadings</name>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>Import Readings…</source>
      <translation>Messwerte importieren…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>Reads a table of measured errors: laser, ballbar, diagonals, tracker or probe</source>
      <translation>Liest eine Tabelle gemessener Fehler: Laser, Kreisformtest, Diagonalen, Tracker oder Taster</translation>
    </message>
  </context>
  <context>
    <name>Sens_Jog</name>
    <message>
      <location filename="../../sensworkbench/gui/task_jog.py" />
      <source>Jog…</source>
      <translation>Verfahren…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_jog.py" />
      <source>Moves the axes and all they carry; shows the Abbe offsets as arrows</source>
      <translation>Verfährt die Achsen mit allem, was sie tragen; zeigt die Abbe-Abstände als Pfeile</translation>
    </message>
  </context>
  <context>
    <name>Sens_Limits</name>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>Limits of the Error…</source>
      <translation>Grenzen der Abweichung…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>Says how large the error may become, and how often it exceeds a limit</source>
      <translation>Sagt, wie groß die Abweichung werden kann und wie oft sie eine Grenze überschreitet</translation>
    </message>
  </context>
  <context>
    <name>Sens_Machine</name>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Machine from Selection…</source>
      <translation>Maschine aus Auswahl…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Makes a machine from parts: which is the bed, and which carries X, Y, Z, spindle and table</source>
      <translation>Macht aus Teilen eine Maschine: was das Bett ist und was X, Y, Z, Spindel und Tisch trägt</translation>
    </message>
  </context>
  <context>
    <name>Sens_MachineFromAssembly</name>
    <message>
      <location filename="../../sensworkbench/gui/task_assembly.py" />
      <source>Machine from Assembly…</source>
      <translation>Maschine aus Baugruppe…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_assembly.py" />
      <source>Makes a machine from an assembly: its sliders are the axes</source>
      <translation>Macht aus einer Baugruppe eine Maschine: ihre Schieber sind die Achsen</translation>
    </message>
  </context>
  <context>
    <name>Sens_Motion</name>
    <message>
      <location filename="../../sensworkbench/gui/task_motion.py" />
      <source>Moves the body of an error or effect in the view, exaggerated and animated</source>
      <translation>Bewegt den Körper eines Fehlers oder Effekts in der Ansicht, überhöht und animiert</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_motion.py" />
      <source>Show Motion…</source>
      <translation>Bewegung zeigen…</translation>
    </message>
  </context>
  <context>
    <name>Sens_Moves</name>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>Says what moving a scale, guide block or the tool by a millimetre is worth</source>
      <translation>Sagt, was ein Millimeter Verschiebung eines Maßstabs, Führungswagens oder des Werkzeugs wert ist</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>Where to Move…</source>
      <translation>Wohin verschieben…</translation>
    </message>
  </context>
  <context>
    <name>Sens_OriginalColours</name>
    <message>
      <location filename="../../sensworkbench/gui/analysis.py" />
      <source>Gives every part the colours back that it had before, or shows those of the result again</source>
      <translation>Gibt jedem Teil seine früheren Farben zurück oder zeigt wieder die des Ergebnisses</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/analysis.py" />
      <source>Original Colours</source>
      <translation>Ursprüngliche Farben</translation>
    </message>
  </context>
  <context>
    <name>Sens_Part</name>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Shows the part that the tool path of the document makes, and who spoils it</source>
      <translation>Zeigt das Werkstück, das der Werkzeugweg des Dokuments ergibt, und wer es verdirbt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>The Part…</source>
      <translation>Das Werkstück…</translation>
    </message>
  </context>
  <context>
    <name>Sens_Plan</name>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>Plan Measurement…</source>
      <translation>Messung planen…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>Says how well each declared error will be known, before anything is measured</source>
      <translation>Sagt vor der Messung, wie genau jede angegebene Abweichung bekannt sein wird</translation>
    </message>
  </context>
  <context>
    <name>Sens_Repair</name>
    <message>
      <location filename="../../sensworkbench/gui/task_repair.py" />
      <source>Repair Machine…</source>
      <translation>Maschine reparieren…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_repair.py" />
      <source>Says what is wrong with the objects of a machine and mends what can be mended</source>
      <translation>Sagt, was an den Objekten einer Maschine nicht stimmt, und repariert, was sich reparieren lässt</translation>
    </message>
  </context>
  <context>
    <name>Sens_Report</name>
    <message>
      <location filename="../../sensworkbench/gui/export.py" />
      <source>Export Report…</source>
      <translation>Bericht ausgeben…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/export.py" />
      <source>Writes the ranking as HTML with a picture of the view, and as JSON and CSV</source>
      <translation>Schreibt die Rangfolge als HTML mit Bild der Ansicht sowie als JSON und CSV</translation>
    </message>
  </context>
  <context>
    <name>Sens_Residuals</name>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Residuals</source>
      <translation>Residuen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Shows the residuals before and after as arrows in the workspace, or hides them</source>
      <translation>Zeigt die Residuen vorher und nachher als Pfeile im Arbeitsraum oder verbirgt sie</translation>
    </message>
  </context>
  <context>
    <name>Sens_Review</name>
    <message>
      <location filename="../../sensworkbench/gui/analysis.py" />
      <source>Review</source>
      <translation>Durchsprache</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/analysis.py" />
      <source>Shows the ranking, the components and what-if beside the model</source>
      <translation>Zeigt Rangfolge, Komponenten und Was-wäre-wenn neben dem Modell</translation>
    </message>
  </context>
  <context>
    <name>Sens_Sensitivity</name>
    <message>
      <location filename="../../sensworkbench/gui/analysis.py" />
      <source>Computes the indices of every error, colours the parts and shows the ranking</source>
      <translation>Berechnet die Indizes jeder Abweichung, färbt die Teile und zeigt die Rangfolge</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/analysis.py" />
      <source>Sensitivity</source>
      <translation>Sensitivität</translation>
    </message>
  </context>
  <context>
    <name>Sens_Sweep</name>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Computes the machine in many variants: table, Pareto front, parallel coordinates</source>
      <translation>Berechnet die Maschine in vielen Varianten: Tabelle, Pareto-Front, Parallelkoordinaten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Try Many Designs…</source>
      <translation>Viele Entwürfe probieren…</translation>
    </message>
  </context>
  <context>
    <name>Sens_SwitchEffect</name>
    <message>
      <location filename="../../sensworkbench/gui/task_effect.py" />
      <source>Effect On or Off</source>
      <translation>Effekt ein oder aus</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_effect.py" />
      <source>Switches the selected effect off, or on again</source>
      <translation>Schaltet den gewählten Effekt aus oder wieder ein</translation>
    </message>
  </context>
  <context>
    <name>Sens_Tables</name>
    <message>
      <location filename="../../sensworkbench/gui/task_tables.py" />
      <source>Export Compensation Tables…</source>
      <translation>Kompensationstabellen exportieren…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tables.py" />
      <source>Writes the fitted errors as tables of a controller, and states what they cannot hold</source>
      <translation>Schreibt die angepassten Abweichungen als Tabellen einer Steuerung und sagt, was sie nicht enthalten können</translation>
    </message>
  </context>
  <context>
    <name>Sens_Tolerances</name>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Edits limits and distribution of every error in a table</source>
      <translation>Bearbeitet Grenzen und Verteilung jeder Abweichung in einer Tabelle</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Tolerances…</source>
      <translation>Toleranzen…</translation>
    </message>
  </context>
  <context>
    <name>Sens_Trace</name>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Searches for the effect that explains what the declared errors leave over</source>
      <translation>Sucht den Effekt, der erklärt, was die angesetzten Fehler übrig lassen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Trace…</source>
      <translation>Ursache suchen…</translation>
    </message>
  </context>
  <context>
    <name>Sens_TraceReport</name>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Export Trace Report…</source>
      <translation>Bericht der Ursachensuche exportieren…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Writes what was found as HTML and JSON, with the augmented machine</source>
      <translation>Schreibt das Gefundene als HTML und JSON, mit der ergänzten Maschine</translation>
    </message>
  </context>
  <context>
    <name>Workbench</name>
    <message>
      <location filename="../../sensworkbench/gui/command.py" />
      <source>Sens Analysis</source>
      <translation>Sens Analyse</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/command.py" />
      <source>Sens Closed Loop</source>
      <translation>Sens Ursachensuche</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/command.py" />
      <source>Sens Machine</source>
      <translation>Sens Maschine</translation>
    </message>
    <message>
      <location filename="../../InitGui.py" />
      <source>Shows which component of a machine tool spoils its accuracy, from its Abbe offsets</source>
      <translation>Zeigt aus den Abbe-Abständen, welche Komponente einer Werkzeugmaschine die Genauigkeit verdirbt</translation>
    </message>
  </context>
</TS>
