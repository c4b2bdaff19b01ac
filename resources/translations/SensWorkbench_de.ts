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
      <location filename="../../sensworkbench/gui/task_jog.py" />
      <source>Abbe offset / mm</source>
      <translation>Abbe-Abstand / mm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Abbe offset here: {offset} mm</source>
      <translation>Abbe-Abstand hier: {offset} mm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/pointers.py" />
      <source>Abbe offset {name}: {length} mm</source>
      <translation>Abbe-Abstand {name}: {length} mm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Add</source>
      <translation>Hinzufügen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Adds the selected parts</source>
      <translation>Fügt die gewählten Teile hinzu</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_jog.py" />
      <source>All axes to 0</source>
      <translation>Alle Achsen auf 0</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Angles in</source>
      <translation>Winkel in</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Angles of new tolerance tables</source>
      <translation>Winkel in neuen Toleranztabellen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Another panel is open. Close it first.</source>
      <translation>Ein anderes Fenster ist offen. Bitte zuerst schließen.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Apply</source>
      <translation>Anwenden</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Apply what-if</source>
      <translation>Was-wäre-wenn anwenden</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>At X {x}, Y {y}, Z {z} mm</source>
      <translation>Bei X {x}, Y {y}, Z {z} mm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Automatic</source>
      <translation>Automatisch</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Back to the default</source>
      <translation>Zurück zur Vorgabe</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/bars.py" />
      <source>Bar: Sᵀ of the component; dark: S. Below: Sᵀ of its errors, one after the other.</source>
      <translation>Balken: Sᵀ der Komponente, dunkel: S. Darunter: Sᵀ ihrer Abweichungen nacheinander.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>Bed</source>
      <translation>Bett</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/live.py" />
      <source>Cancel</source>
      <translation>Abbrechen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/messages.py" />
      <source>Cancelled; nothing was changed</source>
      <translation>Abgebrochen; nichts wurde geändert</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Change</source>
      <translation>Änderung</translation>
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
      <location filename="../../sensworkbench/gui/export.py" />
      <source>Compute the sensitivity again, then export.</source>
      <translation>Die Sensitivität neu berechnen, dann ausgeben.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/export.py" />
      <source>Compute the sensitivity first.</source>
      <translation>Zuerst die Sensitivität berechnen.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Computes the indices of the machine as it is now</source>
      <translation>Berechnet die Indizes der Maschine, wie sie jetzt ist</translation>
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
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Correct it, or press Cancel.</source>
      <translation>Bitte berichtigen oder Abbrechen drücken.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Defaults</source>
      <translation>Vorgaben</translation>
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
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Distribution</source>
      <translation>Verteilung</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/viewproviders.py" />
      <source>Edit axis…</source>
      <translation>Achse bearbeiten…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Edit machine</source>
      <translation>Maschine bearbeiten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/viewproviders.py" />
      <source>Edit machine…</source>
      <translation>Maschine bearbeiten…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/ranking.py" />
      <source>Error</source>
      <translation>Abweichung</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Error map</source>
      <translation>Fehlerkarte</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Errors</source>
      <translation>Abweichungen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Exchange the two limits.</source>
      <translation>Die beiden Grenzen vertauschen.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Expected error over the workspace as points</source>
      <translation>Erwarteter Fehler im Arbeitsraum als Punkte</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/errormap.py" />
      <source>Expected error √E[Y]</source>
      <translation>Erwarteter Fehler √E[Y]</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/viewproviders.py" />
      <source>Export report…</source>
      <translation>Bericht ausgeben…</translation>
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
      <location filename="../../sensworkbench/gui/export.py" />
      <source>Folder for the report</source>
      <translation>Ordner für den Bericht</translation>
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
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Gives the selected errors the limits ± this value</source>
      <translation>Gibt den gewählten Abweichungen die Grenzen ± dieser Wert</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Grid, positions per axis</source>
      <translation>Gitter, Positionen je Achse</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_jog.py" />
      <source>Home</source>
      <translation>Nullpunkt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>How it is shown</source>
      <translation>Wie es gezeigt wird</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Import tolerances</source>
      <translation>Toleranzen einlesen</translation>
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
      <location filename="../../sensworkbench/gui/viewproviders.py" />
      <source>Jog…</source>
      <translation>Verfahren…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>Largest total index Sᵀ of the component</source>
      <translation>Größter totaler Index Sᵀ der Komponente</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Legend</source>
      <translation>Legende</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Look of the result</source>
      <translation>Aussehen des Ergebnisses</translation>
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
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Machine</source>
      <translation>Maschine</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Machine from selection</source>
      <translation>Maschine aus Auswahl</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Magma (black to pale yellow)</source>
      <translation>Magma (schwarz bis blassgelb)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/ranking.py" />
      <source>Meaning</source>
      <translation>Bedeutung</translation>
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
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Not square as designed: {pairs}</source>
      <translation>Laut Konstruktion nicht rechtwinklig: {pairs}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Objective</source>
      <translation>Zielgröße</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>One position</source>
      <translation>Eine Position</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Orientation of the tool</source>
      <translation>Orientierung des Werkzeugs</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Original colours</source>
      <translation>Ursprüngliche Farben</translation>
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
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Output</source>
      <translation>Ausgang</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>Over a grid of {counts} positions</source>
      <translation>Über ein Gitter von {counts} Positionen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>Over the workspace, {counts} positions</source>
      <translation>Über den Arbeitsraum, {counts} Positionen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Park &amp; Yang's values for all errors</source>
      <translation>Werte von Park &amp; Yang für alle Abweichungen</translation>
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
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Picture…</source>
      <translation>Bild…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Position</source>
      <translation>Position</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
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
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Reference from</source>
      <translation>Bezug aus</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Reference point: {vector} mm ({source})</source>
      <translation>Bezugspunkt: {vector} mm ({source})</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/pointers.py" />
      <source>Reference {name}</source>
      <translation>Bezug {name}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Report…</source>
      <translation>Bericht…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Reversed</source>
      <translation>Umgekehrt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/viewproviders.py" />
      <source>Review…</source>
      <translation>Durchsprache…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/export.py" />
      <source>Save picture</source>
      <translation>Bild speichern</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Saves the 3D view with its legend</source>
      <translation>Speichert die 3D-Ansicht mit ihrer Legende</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Select one coordinate system, datum, vertex, edge, face or part first.</source>
      <translation>Zuerst ein Koordinatensystem, Bezugselement, einen Punkt, eine Kante, Fläche oder ein Teil wählen.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Select one or more parts in the view or the tree first.</source>
      <translation>Zuerst ein oder mehrere Teile in Ansicht oder Baum wählen.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
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
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Show</source>
      <translation>Zeigen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Signed sum</source>
      <translation>Summe mit Vorzeichen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>Spindle and tool</source>
      <translation>Spindel und Werkzeug</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Squareness</source>
      <translation>Rechtwinkligkeit</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Start over</source>
      <translation>Von vorn</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/live.py" />
      <source>Stopping…</source>
      <translation>Wird angehalten…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Structure</source>
      <translation>Struktur</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Structure (workpiece → tool, F: bed)</source>
      <translation>Struktur (Werkstück → Werkzeug, F: Bett)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Sum of squares</source>
      <translation>Quadratsumme</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Sᵀ now</source>
      <translation>Sᵀ jetzt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Sᵀ then</source>
      <translation>Sᵀ dann</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Take</source>
      <translation>Nehmen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Take selection</source>
      <translation>Auswahl nehmen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Takes the coordinate system, datum, edge, face or part that is selected</source>
      <translation>Nimmt das gewählte Koordinatensystem, Bezugselement, die Kante, Fläche oder das Teil</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>The parts selected in the view or the tree become this component</source>
      <translation>Die in Ansicht oder Baum gewählten Teile werden diese Komponente</translation>
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
      <location filename="../../sensworkbench/gui/viewproviders.py" />
      <source>Tolerances…</source>
      <translation>Toleranzen…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Tool point</source>
      <translation>Werkzeugpunkt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>Total index Sᵀ of the component</source>
      <translation>Totaler Index Sᵀ der Komponente</translation>
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
      <source>Total index: its share with all interactions. Bar: Sᵀ; dark inside: S</source>
      <translation>Totaler Index: ihr Anteil mit allen Wechselwirkungen. Balken: Sᵀ; dunkel darin: S</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Travel</source>
      <translation>Verfahrweg</translation>
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
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Unit</source>
      <translation>Einheit</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Unit in which all angles are shown</source>
      <translation>Einheit, in der alle Winkel gezeigt werden</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>Unit: 1 (share of the variance)</source>
      <translation>Einheit: 1 (Anteil an der Varianz)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Units</source>
      <translation>Einheiten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Upper</source>
      <translation>Obere</translation>
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
      <location filename="../../sensworkbench/gui/display.py" />
      <source>Variance-weighted total index Sᵀ</source>
      <translation>Varianzgewichteter totaler Index Sᵀ</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Viridis (purple to yellow)</source>
      <translation>Viridis (violett bis gelb)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Weight of each component; 0 leaves it out (a groove does not care along its length)</source>
      <translation>Gewicht jeder Komponente; 0 lässt sie weg (längs einer Nut ist sie gleichgültig)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Weights</source>
      <translation>Gewichte</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>What if</source>
      <translation>Was wäre wenn</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>What is judged</source>
      <translation>Was beurteilt wird</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>Workpiece and fixture</source>
      <translation>Werkstück und Vorrichtung</translation>
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
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Writes HTML, JSON and CSV</source>
      <translation>Schreibt HTML, JSON und CSV</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Writes the tolerances and weights to the machine, one undo step</source>
      <translation>Schreibt Toleranzen und Gewichte in die Maschine, ein Schritt zum Rückgängigmachen</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Writes tolerances as CSV or JSON</source>
      <translation>Schreibt Toleranzen als CSV oder JSON</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/export.py" />
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
      <source>Z carriage</source>
      <translation>Z-Schlitten</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>a quarter</source>
      <translation>ein Viertel</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>also turns what the guide carries</source>
      <translation>dreht auch, was die Führung trägt</translation>
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
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>at its centre of mass</source>
      <translation>an seinem Schwerpunkt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>at its placement</source>
      <translation>an seiner Platzierung</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>bed</source>
      <translation>Bett</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>doubled</source>
      <translation>verdoppelt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>fixed value</source>
      <translation>fester Wert</translation>
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
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>its local X</source>
      <translation>sein lokales X</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>its local Y</source>
      <translation>sein lokales Y</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>its local Z</source>
      <translation>sein lokales Z</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>largest component then: {name}, Sᵀ = {value}</source>
      <translation>größte Komponente dann: {name}, Sᵀ = {value}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>no index</source>
      <translation>kein Index</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>normal (limits ±3σ)</source>
      <translation>normal (Grenzen ±3σ)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>positioning of {body}</source>
      <translation>Positionierung von {body}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>roll of {body}</source>
      <translation>Rollen von {body}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>spindle, shift along {axis}</source>
      <translation>Spindel, Verschiebung in {axis}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>spindle, tilt about {axis}</source>
      <translation>Spindel, Kippen um {axis}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>squareness carried</source>
      <translation>Rechtwinkligkeit wird mitgeführt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>squareness of {body} to {other}</source>
      <translation>Rechtwinkligkeit von {body} zu {other}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>squareness tilts the direction (ISO)</source>
      <translation>Rechtwinkligkeit neigt die Richtung (ISO)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>straightness of {body} along {axis}</source>
      <translation>Geradheit von {body} in {axis}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/export.py" />
      <source>the document has no 3D view</source>
      <translation>das Dokument hat keine 3D-Ansicht</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>the first part</source>
      <translation>das erste Teil</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>the parts</source>
      <translation>die Teile</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/export.py" />
      <source>the result is out of date</source>
      <translation>das Ergebnis ist veraltet</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>the upper limit is below the lower limit</source>
      <translation>die obere Grenze liegt unter der unteren</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/export.py" />
      <source>there is no result yet</source>
      <translation>es gibt noch kein Ergebnis</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>tilt of {body} about {axis}</source>
      <translation>Kippen von {body} um {axis}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>tilts the direction of motion (ISO 230-1)</source>
      <translation>neigt die Bewegungsrichtung (ISO 230-1)</translation>
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
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>uniform</source>
      <translation>gleichverteilt</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>workpiece</source>
      <translation>Werkstück</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>workpiece, rotation about {axis}</source>
      <translation>Werkstück, Drehung um {axis}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>workpiece, shift along {axis}</source>
      <translation>Werkstück, Verschiebung in {axis}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/pointers.py" />
      <source>{name}: {low} … {high} mm</source>
      <translation>{name}: {low} … {high} mm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>{n} errors read.</source>
      <translation>{n} Abweichungen eingelesen.</translation>
    </message>
  </context>
  <context>
    <name>Sens_EditMachine</name>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Changes chains, carriages, directions, reference points and travel</source>
      <translation>Ändert Ketten, Schlitten, Richtungen, Bezugspunkte und Verfahrwege</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Edit Machine…</source>
      <translation>Maschine bearbeiten…</translation>
    </message>
  </context>
  <context>
    <name>Sens_ErrorMap</name>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Error Map</source>
      <translation>Fehlerkarte</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Shows the expected error over the workspace as coloured points, or hides it</source>
      <translation>Zeigt den erwarteten Fehler im Arbeitsraum als farbige Punkte oder blendet ihn aus</translation>
    </message>
  </context>
  <context>
    <name>Sens_Example</name>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Example Machine</source>
      <translation>Beispielmaschine</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Makes an example machine in an empty or new document</source>
      <translation>Macht eine Beispielmaschine in einem leeren oder neuen Dokument</translation>
    </message>
  </context>
  <context>
    <name>Sens_ExampleFXYZ</name>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Gantry (FXYZ)</source>
      <translation>Portal (FXYZ)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Makes a gantry machine: the tool carries out all three motions</source>
      <translation>Macht eine Portalmaschine: das Werkzeug führt alle drei Bewegungen aus</translation>
    </message>
  </context>
  <context>
    <name>Sens_ExampleXYFZ</name>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Makes a machining centre: table on cross slides, spindle on the column</source>
      <translation>Macht ein Bearbeitungszentrum: Tisch auf Kreuzschlitten, Spindel am Ständer</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Vertical Machining Centre (XYFZ)</source>
      <translation>Senkrecht-Bearbeitungszentrum (XYFZ)</translation>
    </message>
  </context>
  <context>
    <name>Sens_ExampleYFXZ</name>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Makes a travelling-column machine: the table moves along Y</source>
      <translation>Macht eine Fahrständermaschine: der Tisch fährt in Y</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Travelling Column (YFXZ)</source>
      <translation>Fahrständer (YFXZ)</translation>
    </message>
  </context>
  <context>
    <name>Sens_Jog</name>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Jog…</source>
      <translation>Verfahren…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Moves the axes and all they carry; shows the Abbe offsets as arrows</source>
      <translation>Verfährt die Achsen mit allem, was sie tragen; zeigt die Abbe-Abstände als Pfeile</translation>
    </message>
  </context>
  <context>
    <name>Sens_Machine</name>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Machine from Selection…</source>
      <translation>Maschine aus Auswahl…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Makes a machine from parts: which is the bed, and which carries X, Y, Z, spindle and table</source>
      <translation>Macht aus Teilen eine Maschine: was das Bett ist und was X, Y, Z, Spindel und Tisch trägt</translation>
    </message>
  </context>
  <context>
    <name>Sens_OriginalColours</name>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Gives every part the colours back that it had before</source>
      <translation>Gibt jedem Teil seine früheren Farben zurück</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Original Colours</source>
      <translation>Ursprüngliche Farben</translation>
    </message>
  </context>
  <context>
    <name>Sens_Report</name>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Export Report…</source>
      <translation>Bericht ausgeben…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Writes the ranking as HTML with a picture of the view, and as JSON and CSV</source>
      <translation>Schreibt die Rangfolge als HTML mit Bild der Ansicht sowie als JSON und CSV</translation>
    </message>
  </context>
  <context>
    <name>Sens_Review</name>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Review</source>
      <translation>Durchsprache</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Shows the ranking, the components and what-if beside the model</source>
      <translation>Zeigt Rangfolge, Komponenten und Was-wäre-wenn neben dem Modell</translation>
    </message>
  </context>
  <context>
    <name>Sens_Sensitivity</name>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Computes the indices of every error, colours the parts and shows the ranking</source>
      <translation>Berechnet die Indizes jeder Abweichung, färbt die Teile und zeigt die Rangfolge</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Sensitivity</source>
      <translation>Sensitivität</translation>
    </message>
  </context>
  <context>
    <name>Sens_Tolerances</name>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Edits limits and distribution of every error in a table</source>
      <translation>Bearbeitet Grenzen und Verteilung jeder Abweichung in einer Tabelle</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Tolerances…</source>
      <translation>Toleranzen…</translation>
    </message>
  </context>
  <context>
    <name>Workbench</name>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Sens Analysis</source>
      <translation>Sens Analyse</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
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
