<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ko" sourcelanguage="en">
  <context>
    <name>Sens</name>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>(none)</source>
      <translation>(없음)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_jog.py" />
      <source>Abbe offset / mm</source>
      <translation>아베 오프셋 / mm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Abbe offset here: {offset} mm</source>
      <translation>현재 아베 오프셋: {offset} mm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/pointers.py" />
      <source>Abbe offset {name}: {length} mm</source>
      <translation>아베 오프셋 {name}: {length} mm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Add</source>
      <translation>추가</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Adds the selected parts</source>
      <translation>선택한 부품을 추가합니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_jog.py" />
      <source>All axes to 0</source>
      <translation>모든 축을 0으로</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Angles in</source>
      <translation>각도 단위</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Angles of new tolerance tables</source>
      <translation>새 공차표의 각도</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Another panel is open. Close it first.</source>
      <translation>다른 패널이 열려 있습니다. 먼저 닫으십시오.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Apply</source>
      <translation>적용하기</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Apply what-if</source>
      <translation>가정 분석 적용</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>At X {x}, Y {y}, Z {z} mm</source>
      <translation>위치 X {x}, Y {y}, Z {z} mm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Automatic</source>
      <translation>자동</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Back to the default</source>
      <translation>기본값으로</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/bars.py" />
      <source>Bar: Sᵀ of the component; dark: S. Below: Sᵀ of its errors, one after the other.</source>
      <translation>막대: 구성요소의 Sᵀ, 어두운 부분: S. 아래: 각 오차의 Sᵀ를 차례로 표시.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>Bed</source>
      <translation>베드</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/live.py" />
      <source>Cancel</source>
      <translation>취소</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/messages.py" />
      <source>Cancelled; nothing was changed</source>
      <translation>취소됨; 바뀐 것이 없습니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Change</source>
      <translation>변경</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Cividis (blue to yellow)</source>
      <translation>Cividis (파랑에서 노랑)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Clear</source>
      <translation>비우기</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_jog.py" />
      <source>Colour by the indices at this position</source>
      <translation>이 위치의 지수로 채색</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Colour map</source>
      <translation>색상표</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Colours and legend of new results</source>
      <translation>새 결과의 색상과 범례</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/ranking.py" />
      <source>Component</source>
      <translation>구성요소</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Components</source>
      <translation>구성요소</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Compute</source>
      <translation>계산</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Compute again</source>
      <translation>다시 계산</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/export.py" />
      <source>Compute the sensitivity again, then export.</source>
      <translation>민감도를 다시 계산한 뒤 내보내십시오.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/export.py" />
      <source>Compute the sensitivity first.</source>
      <translation>먼저 민감도를 계산하십시오.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Computes the indices of the machine as it is now</source>
      <translation>현재 기계의 지수를 계산합니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Computing</source>
      <translation>계산</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/live.py" />
      <source>Computing the indices at {n} positions</source>
      <translation>{n}개 위치에서 지수를 계산하는 중</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Correct it, or press Cancel.</source>
      <translation>고치거나 취소를 누르십시오.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Defaults</source>
      <translation>기본값</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Direction from</source>
      <translation>방향 출처</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Direction: {vector} ({source})</source>
      <translation>방향: {vector} ({source})</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Distribution</source>
      <translation>분포</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/viewproviders.py" />
      <source>Edit axis…</source>
      <translation>축 편집…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Edit machine</source>
      <translation>기계 편집</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/viewproviders.py" />
      <source>Edit machine…</source>
      <translation>기계 편집…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/ranking.py" />
      <source>Error</source>
      <translation>오차</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Error map</source>
      <translation>오차 지도</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Errors</source>
      <translation>오차</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Exchange the two limits.</source>
      <translation>두 한계를 서로 바꾸십시오.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Expected error over the workspace as points</source>
      <translation>작업 공간의 예상 오차를 점으로</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/errormap.py" />
      <source>Expected error √E[Y]</source>
      <translation>예상 오차 √E[Y]</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/viewproviders.py" />
      <source>Export report…</source>
      <translation>보고서 내보내기…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Export tolerances</source>
      <translation>공차 내보내기</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Export…</source>
      <translation>내보내기…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>First-order index S of the component</source>
      <translation>구성요소의 1차 지수 S</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>First-order index, mean over the positions</source>
      <translation>1차 지수, 위치 평균</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/ranking.py" />
      <source>First-order index: the share of the variance that the error has by itself</source>
      <translation>1차 지수: 오차가 단독으로 갖는 분산의 비율</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/export.py" />
      <source>Folder for the report</source>
      <translation>보고서 폴더</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>From 0 to just above the largest index</source>
      <translation>0부터 최대 지수 바로 위까지</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>From 0 to just above the largest index; otherwise the range sticks</source>
      <translation>0부터 최대 지수 바로 위까지; 끄면 범위가 고정됩니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>General</source>
      <translation>일반</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Gives every part its own colours back</source>
      <translation>모든 부품에 원래 색상을 되돌려 줍니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Gives the selected errors the limits ± this value</source>
      <translation>선택한 오차의 한계를 ± 이 값으로 합니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Grid, positions per axis</source>
      <translation>격자, 축당 위치 수</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_jog.py" />
      <source>Home</source>
      <translation>원점</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>How it is shown</source>
      <translation>표시 방법</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Import tolerances</source>
      <translation>공차 가져오기</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Import…</source>
      <translation>가져오기…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_jog.py" />
      <source>Jog</source>
      <translation>조그</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_jog.py" />
      <source>Jog {name}</source>
      <translation>{name} 조그</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/viewproviders.py" />
      <source>Jog…</source>
      <translation>조그…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>Largest total index Sᵀ of the component</source>
      <translation>구성요소의 최대 전체 지수 Sᵀ</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Legend</source>
      <translation>범례</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Look of the result</source>
      <translation>결과의 모양</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Lower</source>
      <translation>하한</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Lower left</source>
      <translation>왼쪽 아래</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Lower right</source>
      <translation>오른쪽 아래</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Machine</source>
      <translation>기계</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Machine from selection</source>
      <translation>선택에서 기계 만들기</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Magma (black to pale yellow)</source>
      <translation>Magma (검정에서 옅은 노랑)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/ranking.py" />
      <source>Meaning</source>
      <translation>의미</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>No machine in this document. Start with &lt;b&gt;Machine from Selection…&lt;/b&gt; or &lt;b&gt;Example Machine&lt;/b&gt;.</source>
      <translation>이 문서에 기계가 없습니다. &lt;b&gt;선택에서 기계 만들기…&lt;/b&gt; 또는 &lt;b&gt;예제 기계&lt;/b&gt;로 시작하십시오.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>No result yet: press &lt;b&gt;Compute again&lt;/b&gt;.</source>
      <translation>아직 결과가 없습니다: &lt;b&gt;다시 계산&lt;/b&gt;을 누르십시오.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Not square as designed: {pairs}</source>
      <translation>설계상 직각이 아님: {pairs}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Objective</source>
      <translation>목적 함수</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>One position</source>
      <translation>한 위치</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Orientation of the tool</source>
      <translation>공구의 자세</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Original colours</source>
      <translation>원래 색상</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>Out of date: the machine has changed</source>
      <translation>오래됨: 기계가 바뀌었습니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Out of date: the machine has changed since.</source>
      <translation>오래됨: 그 뒤로 기계가 바뀌었습니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Output</source>
      <translation>출력</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>Over a grid of {counts} positions</source>
      <translation>{counts}개 위치의 격자</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>Over the workspace, {counts} positions</source>
      <translation>작업 공간 전체, {counts}개 위치</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Park &amp; Yang's values for all errors</source>
      <translation>모든 오차에 Park &amp; Yang의 값</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Parts</source>
      <translation>부품</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Parts show</source>
      <translation>부품이 나타내는 값</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Per axis</source>
      <translation>축당</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Picture…</source>
      <translation>그림…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Position</source>
      <translation>위치</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Position of the tool</source>
      <translation>공구의 위치</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Positions</source>
      <translation>위치들</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Positions of a new machine</source>
      <translation>새 기계의 위치</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Positions per axis</source>
      <translation>축당 위치 수</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Quadrature, positions per axis</source>
      <translation>구적법, 축당 위치 수</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Range</source>
      <translation>범위</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Rank</source>
      <translation>순위</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Reads tolerances from CSV or JSON</source>
      <translation>CSV나 JSON에서 공차를 읽습니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Recolour at once when the machine changes</source>
      <translation>기계가 바뀌면 바로 다시 채색</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_jog.py" />
      <source>Recolours while the axes move; off: the colours of the result stay</source>
      <translation>축이 움직이는 동안 다시 채색; 끄면 결과의 색상이 유지됩니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Reference from</source>
      <translation>기준점 출처</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Reference point: {vector} mm ({source})</source>
      <translation>기준점: {vector} mm ({source})</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/pointers.py" />
      <source>Reference {name}</source>
      <translation>기준점 {name}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Report…</source>
      <translation>보고서…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Reversed</source>
      <translation>반대로</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/viewproviders.py" />
      <source>Review…</source>
      <translation>검토…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/export.py" />
      <source>Save picture</source>
      <translation>그림 저장</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Saves the 3D view with its legend</source>
      <translation>범례와 함께 3D 화면을 저장합니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Select one coordinate system, datum, vertex, edge, face or part first.</source>
      <translation>먼저 좌표계, 데이텀, 꼭짓점, 모서리, 면 또는 부품을 하나 선택하십시오.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Select one or more parts in the view or the tree first.</source>
      <translation>먼저 화면이나 트리에서 부품을 하나 이상 선택하십시오.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Sensitivity</source>
      <translation>민감도</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Sensitivity review</source>
      <translation>민감도 검토</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Set</source>
      <translation>적용</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Set ± for selected</source>
      <translation>선택에 ± 적용</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Settings</source>
      <translation>설정</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Show</source>
      <translation>표시</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Signed sum</source>
      <translation>부호 있는 합</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>Spindle and tool</source>
      <translation>주축과 공구</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Squareness</source>
      <translation>직각도</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Start over</source>
      <translation>처음부터</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/live.py" />
      <source>Stopping…</source>
      <translation>멈추는 중…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Structure</source>
      <translation>구조</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Structure (workpiece → tool, F: bed)</source>
      <translation>구조 (공작물 → 공구, F: 베드)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Sum of squares</source>
      <translation>제곱합</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Sᵀ now</source>
      <translation>현재 Sᵀ</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Sᵀ then</source>
      <translation>이후 Sᵀ</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Take</source>
      <translation>사용</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Take selection</source>
      <translation>선택 사용</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Takes the coordinate system, datum, edge, face or part that is selected</source>
      <translation>선택한 좌표계, 데이텀, 모서리, 면 또는 부품을 사용합니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>The parts selected in the view or the tree become this component</source>
      <translation>화면이나 트리에서 선택한 부품이 이 구성요소가 됩니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/ranking.py" />
      <source>Tolerance</source>
      <translation>공차</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Tolerance of the selected errors</source>
      <translation>선택한 오차의 공차</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Tolerances</source>
      <translation>공차</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Tolerances of {name}</source>
      <translation>{name}의 공차</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/viewproviders.py" />
      <source>Tolerances…</source>
      <translation>공차…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Tool point</source>
      <translation>공구점</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>Total index Sᵀ of the component</source>
      <translation>구성요소의 전체 지수 Sᵀ</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Total index, largest over the positions</source>
      <translation>전체 지수, 위치 중 최대</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Total index, mean over the positions</source>
      <translation>전체 지수, 위치 평균</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Total index, weighted by the variance</source>
      <translation>전체 지수, 분산 가중</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/ranking.py" />
      <source>Total index: its share with all interactions. Bar: Sᵀ; dark inside: S</source>
      <translation>전체 지수: 모든 상호작용을 포함한 비율. 막대: Sᵀ, 안쪽 어두운 부분: S</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Travel</source>
      <translation>이송 범위</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Type a value and select the errors that take it.</source>
      <translation>값을 입력하고 적용할 오차를 선택하십시오.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Type limits with decimal point or comma, a unit may follow: 12,5 arcsec.</source>
      <translation>한계를 소수점이나 쉼표로 입력하십시오. 단위를 붙일 수 있습니다: 12,5 arcsec.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>U-shaped</source>
      <translation>U자형</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Unit</source>
      <translation>단위</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Unit in which all angles are shown</source>
      <translation>모든 각도를 표시하는 단위</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>Unit: 1 (share of the variance)</source>
      <translation>단위: 1 (분산의 비율)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Units</source>
      <translation>단위</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Upper</source>
      <translation>상한</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Upper left</source>
      <translation>왼쪽 위</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Upper right</source>
      <translation>오른쪽 위</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>Variance-weighted total index Sᵀ</source>
      <translation>분산 가중 전체 지수 Sᵀ</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Viridis (purple to yellow)</source>
      <translation>Viridis (보라에서 노랑)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Weight of each component; 0 leaves it out (a groove does not care along its length)</source>
      <translation>각 성분의 가중치; 0이면 제외합니다 (홈은 길이 방향 오차와 무관합니다)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Weights</source>
      <translation>가중치</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>What if</source>
      <translation>가정 분석</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>What is judged</source>
      <translation>평가 대상</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>Workpiece and fixture</source>
      <translation>공작물과 고정구</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Workspace, Gauss-Legendre quadrature</source>
      <translation>작업 공간, 가우스-르장드르 구적법</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Workspace, regular grid</source>
      <translation>작업 공간, 규칙 격자</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Writes HTML, JSON and CSV</source>
      <translation>HTML, JSON, CSV를 씁니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Writes the tolerances and weights to the machine, one undo step</source>
      <translation>공차와 가중치를 기계에 기록합니다 (실행 취소 한 단계)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Writes tolerances as CSV or JSON</source>
      <translation>공차를 CSV나 JSON으로 씁니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/export.py" />
      <source>Written: {files}</source>
      <translation>저장됨: {files}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>X carriage</source>
      <translation>X 이송체</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>XYFZ: table X on saddle Y; the spindle moves along Z</source>
      <translation>XYFZ: 새들 Y 위의 테이블 X, 주축은 Z 방향</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>Y carriage</source>
      <translation>Y 이송체</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>Z carriage</source>
      <translation>Z 이송체</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>a quarter</source>
      <translation>4분의 1</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>also turns what the guide carries</source>
      <translation>안내면이 나르는 것도 회전시킴</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>arc seconds (″)</source>
      <translation>초 (″)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>as it is</source>
      <translation>그대로</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>at its centre of mass</source>
      <translation>무게 중심</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>at its placement</source>
      <translation>배치 위치</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>bed</source>
      <translation>베드</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>doubled</source>
      <translation>두 배</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>fixed value</source>
      <translation>고정값</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>for example 5 or 10 arcsec</source>
      <translation>예: 5 또는 10 arcsec</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>from</source>
      <translation>부터</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>frozen</source>
      <translation>고정</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>halved</source>
      <translation>절반</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>its local X</source>
      <translation>로컬 X</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>its local Y</source>
      <translation>로컬 Y</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>its local Z</source>
      <translation>로컬 Z</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>largest component then: {name}, Sᵀ = {value}</source>
      <translation>그때 가장 큰 구성요소: {name}, Sᵀ = {value}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>no index</source>
      <translation>지수 없음</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>normal (limits ±3σ)</source>
      <translation>정규 (한계 ±3σ)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>positioning of {body}</source>
      <translation>{body}의 위치 결정</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>roll of {body}</source>
      <translation>{body}의 롤</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>spindle, shift along {axis}</source>
      <translation>주축, {axis} 방향 이동</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>spindle, tilt about {axis}</source>
      <translation>주축, {axis} 둘레 기울기</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>squareness carried</source>
      <translation>직각도가 함께 전달됨</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>squareness of {body} to {other}</source>
      <translation>{other}에 대한 {body}의 직각도</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>squareness tilts the direction (ISO)</source>
      <translation>직각도는 방향만 기울임 (ISO)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>straightness of {body} along {axis}</source>
      <translation>{body}의 {axis} 방향 진직도</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/export.py" />
      <source>the document has no 3D view</source>
      <translation>문서에 3D 화면이 없습니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>the first part</source>
      <translation>첫째 부품</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>the parts</source>
      <translation>부품</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/export.py" />
      <source>the result is out of date</source>
      <translation>결과가 오래되었습니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>the upper limit is below the lower limit</source>
      <translation>상한이 하한보다 작습니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/export.py" />
      <source>there is no result yet</source>
      <translation>아직 결과가 없습니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>tilt of {body} about {axis}</source>
      <translation>{axis} 둘레의 {body} 기울기</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>tilts the direction of motion (ISO 230-1)</source>
      <translation>운동 방향만 기울임 (ISO 230-1)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>to</source>
      <translation>까지</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>tool</source>
      <translation>공구</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/errormap.py" />
      <source>tool point over the workspace</source>
      <translation>작업 공간의 공구점</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>traced effect</source>
      <translation>추적된 효과</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>triangular</source>
      <translation>삼각</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>truncated normal</source>
      <translation>절단 정규</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>uniform</source>
      <translation>균등</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>workpiece</source>
      <translation>공작물</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>workpiece, rotation about {axis}</source>
      <translation>공작물, {axis} 둘레 회전</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>workpiece, shift along {axis}</source>
      <translation>공작물, {axis} 방향 이동</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/pointers.py" />
      <source>{name}: {low} … {high} mm</source>
      <translation>{name}: {low} … {high} mm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>{n} errors read.</source>
      <translation>오차 {n}개를 읽었습니다.</translation>
    </message>
  </context>
  <context>
    <name>Sens_EditMachine</name>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Changes chains, carriages, directions, reference points and travel</source>
      <translation>운동 사슬, 이송체, 방향, 기준점, 이송 범위를 바꿉니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Edit Machine…</source>
      <translation>기계 편집…</translation>
    </message>
  </context>
  <context>
    <name>Sens_ErrorMap</name>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Error Map</source>
      <translation>오차 지도</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Shows the expected error over the workspace as coloured points, or hides it</source>
      <translation>작업 공간의 예상 오차를 색 점으로 보이거나 숨깁니다</translation>
    </message>
  </context>
  <context>
    <name>Sens_Example</name>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Example Machine</source>
      <translation>예제 기계</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Makes an example machine in an empty or new document</source>
      <translation>빈 문서나 새 문서에 예제 기계를 만듭니다</translation>
    </message>
  </context>
  <context>
    <name>Sens_ExampleFXYZ</name>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Gantry (FXYZ)</source>
      <translation>갠트리 (FXYZ)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Makes a gantry machine: the tool carries out all three motions</source>
      <translation>갠트리 기계를 만듭니다: 공구가 세 운동을 모두 합니다</translation>
    </message>
  </context>
  <context>
    <name>Sens_ExampleXYFZ</name>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Makes a machining centre: table on cross slides, spindle on the column</source>
      <translation>머시닝 센터를 만듭니다: 테이블은 십자 이송대 위, 주축은 컬럼에 있습니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Vertical Machining Centre (XYFZ)</source>
      <translation>수직형 머시닝 센터 (XYFZ)</translation>
    </message>
  </context>
  <context>
    <name>Sens_ExampleYFXZ</name>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Makes a travelling-column machine: the table moves along Y</source>
      <translation>이동 컬럼 기계를 만듭니다: 테이블은 Y 방향으로 움직입니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Travelling Column (YFXZ)</source>
      <translation>이동 컬럼 (YFXZ)</translation>
    </message>
  </context>
  <context>
    <name>Sens_Jog</name>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Jog…</source>
      <translation>조그…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Moves the axes and all they carry; shows the Abbe offsets as arrows</source>
      <translation>축과 축이 나르는 모든 것을 움직이고 아베 오프셋을 화살표로 보여 줍니다</translation>
    </message>
  </context>
  <context>
    <name>Sens_Machine</name>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Machine from Selection…</source>
      <translation>선택에서 기계 만들기…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Makes a machine from parts: which is the bed, and which carries X, Y, Z, spindle and table</source>
      <translation>부품으로 기계를 만듭니다: 베드와 X, Y, Z, 주축, 테이블을 나르는 부품을 지정합니다</translation>
    </message>
  </context>
  <context>
    <name>Sens_OriginalColours</name>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Gives every part the colours back that it had before</source>
      <translation>모든 부품에 이전 색상을 되돌려 줍니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Original Colours</source>
      <translation>원래 색상</translation>
    </message>
  </context>
  <context>
    <name>Sens_Report</name>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Export Report…</source>
      <translation>보고서 내보내기…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Writes the ranking as HTML with a picture of the view, and as JSON and CSV</source>
      <translation>순위를 화면 그림이 있는 HTML과 JSON, CSV로 씁니다</translation>
    </message>
  </context>
  <context>
    <name>Sens_Review</name>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Review</source>
      <translation>검토</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Shows the ranking, the components and what-if beside the model</source>
      <translation>모델 옆에 순위, 구성요소, 가정 분석을 보여 줍니다</translation>
    </message>
  </context>
  <context>
    <name>Sens_Sensitivity</name>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Computes the indices of every error, colours the parts and shows the ranking</source>
      <translation>모든 오차의 지수를 계산하여 부품을 채색하고 순위를 보여 줍니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Sensitivity</source>
      <translation>민감도</translation>
    </message>
  </context>
  <context>
    <name>Sens_Tolerances</name>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Edits limits and distribution of every error in a table</source>
      <translation>모든 오차의 한계와 분포를 표에서 편집합니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Tolerances…</source>
      <translation>공차…</translation>
    </message>
  </context>
  <context>
    <name>Workbench</name>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Sens Analysis</source>
      <translation>Sens 해석</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/commands.py" />
      <source>Sens Machine</source>
      <translation>Sens 기계</translation>
    </message>
    <message>
      <location filename="../../InitGui.py" />
      <source>Shows which component of a machine tool spoils its accuracy, from its Abbe offsets</source>
      <translation>아베 오프셋으로 공작기계의 어느 구성요소가 정밀도를 해치는지 보여 줍니다</translation>
    </message>
  </context>
</TS>
