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
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>+ run</source>
      <translation>+ 회차</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>+ sensor</source>
      <translation>+ 센서</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>+ tool</source>
      <translation>+ 공구</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>, from repeats {pure} µm</source>
      <translation>, 반복 측정에서 {pure} µm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>, stated {stated} µm</source>
      <translation>, 명시값 {stated} µm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>3-D error of readings that took no part in the fit, µm</source>
      <translation>피팅에 쓰지 않은 측정값의 3차원 오차, µm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>3-D rms of readings that took no part in the fit: declared → with the effects</source>
      <translation>맞춤에 쓰이지 않은 측정값의 3차원 rms: 선언 → 효과 포함</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>95 % interval of the held-out rms: {a} … {b} µm before, {c} … {d} µm after.</source>
      <translation>남겨 둔 측정값 rms의 95 % 구간: 전 {a} … {b} µm, 후 {c} … {d} µm.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>95 % of all errors below</source>
      <translation>모든 오차의 95 %의 상한</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>95 % of all errors below {before} → {after} µm.</source>
      <translation>모든 오차의 95 %가 {before} → {after} µm 미만.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>95 % of all parts below {value} µm</source>
      <translation>전체 공작물의 95 %가 {value} µm 미만</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>A FreeCAD process ended without an answer; the report view may say why.</source>
      <translation>FreeCAD 프로세스가 응답 없이 끝났습니다. 보고서 보기에 이유가 있을 수 있습니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>A fleet of machines</source>
      <translation>기계군</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>A machine that goes 3 µm too far has an error of +3 µm and a compensation of −3 µm</source>
      <translation>3 µm 더 가는 기계의 오차는 +3 µm, 보정값은 −3 µm입니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_motion.py" />
      <source>A swing between the ends, or as fitted along a path or over readings</source>
      <translation>양 끝 사이의 왕복, 또는 맞춘 대로 경로나 측정값에 따라</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_jog.py" />
      <source>Abbe offset / {unit}</source>
      <translation>아베 오프셋 / {unit}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Abbe offset here: {offset}</source>
      <translation>현재 아베 오프셋: {offset}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/pointers.py" />
      <source>Abbe offset {name}: {length}</source>
      <translation>아베 오프셋 {name}: {length}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Add</source>
      <translation>추가</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Add effects</source>
      <translation>효과 추가</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Adds the selected parts</source>
      <translation>선택한 부품을 추가합니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>After</source>
      <translation>보정 후</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trial.py" />
      <source>All axes</source>
      <translation>모든 축</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_jog.py" />
      <source>All axes to 0</source>
      <translation>모든 축을 0으로</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>All but the tool</source>
      <translation>공구를 뺀 모든 점</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>All errors</source>
      <translation>모든 오차</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Allocate</source>
      <translation>배분</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Allocate tolerances</source>
      <translation>공차 배분</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Allocating {n} tolerances</source>
      <translation>공차 {n}개를 배분하는 중</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>Allowed</source>
      <translation>허용값</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_motion.py" />
      <source>Along the tool path</source>
      <translation>공구 경로를 따라</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>An effect of {size} µm rms is found (median of those that could be).</source>
      <translation>{size} µm rms의 효과를 찾을 수 있습니다(가능한 것들의 중앙값).</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Angles in</source>
      <translation>각도 단위</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Angles, and those of new tolerance tables</source>
      <translation>각도 및 새 공차표의 각도</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/command.py" />
      <source>Another panel is open. Close it first.</source>
      <translation>다른 패널이 열려 있습니다. 먼저 닫으십시오.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/proposal_note.py" />
      <source>Answer by a click</source>
      <translation>클릭으로 답하기</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Apply</source>
      <translation>적용하기</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Apply what-if</source>
      <translation>가정 분석 적용</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/residuals.py" />
      <source>Arrows {times} times as long as the error</source>
      <translation>화살표는 오차의 {times}배 길이</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_assembly.py" />
      <source>Assembly</source>
      <translation>조립체</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>At a random place of the workspace of a random machine within the tolerances</source>
      <translation>공차 안에 있는 임의의 기계의 작업 공간 임의의 위치에서</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>At {positions} {unit}</source>
      <translation>위치 {positions} {unit}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Automatic</source>
      <translation>자동</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/sources.py" />
      <source>Back to the default</source>
      <translation>기본값으로</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/bars.py" />
      <source>Bar: share of the component in the variance. Below: the shares of its errors, which add to it.</source>
      <translation>막대: 분산에서 구성 요소의 몫. 아래: 그 오차들의 몫이며 합하면 막대와 같습니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>Bed</source>
      <translation>베드</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Before/after</source>
      <translation>전/후</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/first_steps.py" />
      <source>Begin with Sens &gt; Example Machine, or Machine from Selection… on your own parts</source>
      <translation>Sens &gt; 예제 기계로 시작하거나, 자신의 부품으로 “선택에서 기계 만들기…”를 사용하십시오</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/first_steps.py" />
      <source>Begin with a machine</source>
      <translation>기계로 시작하기</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>Best places</source>
      <translation>가장 좋은 위치</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>Better</source>
      <translation>개선</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/live.py" />
      <source>Cancel</source>
      <translation>취소</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Cancelled. Run… with the same folder goes on from there.</source>
      <translation>취소했습니다. 같은 폴더로 실행…하면 이어서 계산합니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/messages.py" />
      <source>Cancelled; nothing was changed</source>
      <translation>취소됨; 바뀐 것이 없습니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Catalogue</source>
      <translation>목록</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Cells of spreadsheets and properties: FreeCAD recomputes each variant</source>
      <translation>스프레드시트 셀과 속성: FreeCAD가 각 변형을 다시 계산합니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Chance by noise alone</source>
      <translation>잡음만으로 나올 확률</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Change</source>
      <translation>변경</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/scenarios.py" />
      <source>Changes</source>
      <translation>변경</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Check on the machine</source>
      <translation>기계에서 확인할 것</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>Choose a row under Best places: a slope says which way, not how far.</source>
      <translation>가장 좋은 위치에서 행을 고르십시오. 기울기는 방향만 말하고 거리는 말하지 않습니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Choose …</source>
      <translation>선택 …</translation>
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
      <location filename="../../sensworkbench/gui/proposal_note.py" />
      <source>Click it in the 3D view or the tree.</source>
      <translation>3D 뷰나 트리에서 클릭하십시오.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_jog.py" />
      <source>Click the place in the 3D view first.</source>
      <translation>먼저 3D 뷰에서 위치를 클릭하십시오.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Click: the parts of the component light up. Double click: its motion</source>
      <translation>클릭: 구성 요소의 부품이 강조됩니다. 더블 클릭: 움직임</translation>
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
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>Column</source>
      <translation>열</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Compensated</source>
      <translation>보정됨</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tables.py" />
      <source>Compensation tables of {name}</source>
      <translation>{name}의 보정 테이블</translation>
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
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Computes every variant; asks for the folder of the files</source>
      <translation>모든 변형을 계산합니다. 파일 폴더를 묻습니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Computes the indices of the machine as it is now</source>
      <translation>현재 기계의 지수를 계산합니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Computes the machine in many variants and shows which of them are best.</source>
      <translation>기계의 여러 변형을 계산하고 어느 것이 가장 좋은지 보여 줍니다.</translation>
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
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Computing {n} variants</source>
      <translation>변형 {n}개를 계산하는 중</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Condition</source>
      <translation>조건수</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>Contribution</source>
      <translation>기여도</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>Contribution to Y; the contributions add to 1</source>
      <translation>Y에 대한 기여; 기여의 합은 1</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/copying.py" />
      <source>Copy</source>
      <translation>복사</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Correct it, or press Cancel.</source>
      <translation>고치거나 취소를 누르십시오.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Correcting the program</source>
      <translation>프로그램을 보정하는 중</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Correlated tolerances</source>
      <translation>상관 공차</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Cost</source>
      <translation>비용</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Cost {cost}; nothing cheaper than {bound} meets the target.</source>
      <translation>비용 {cost}; {bound}보다 싸게는 목표를 만족할 수 없습니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Covariance</source>
      <translation>공분산</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Covariance of errors</source>
      <translation>오차의 공분산</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Declare</source>
      <translation>선언</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Declare source</source>
      <translation>원인 선언</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/residuals.py" />
      <source>Declared errors corrected</source>
      <translation>선언된 오차 보정 후</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Declared errors that moved when the effects joined</source>
      <translation>효과를 넣을 때 바뀐 선언 오차</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Defaults</source>
      <translation>기본값</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Design</source>
      <translation>계획</translation>
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
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Directions of rails, screws and long edges, the longest first</source>
      <translation>레일, 나사, 긴 모서리의 방향 (가장 긴 것부터)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Distribution</source>
      <translation>분포</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/scenarios.py" />
      <source>Double click: try it again. Delete: remove it from the list</source>
      <translation>두 번 클릭: 다시 시도. Delete: 목록에서 제거</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Driven by</source>
      <translation>구동원</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_effect.py" />
      <source>Driver</source>
      <translation>구동 변수</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Each error keeps its own tolerance besides</source>
      <translation>각 오차는 자체 공차도 유지</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Each point: the value that a reading asks of the component when everything else is taken away.</source>
      <translation>각 점: 나머지를 모두 뺀 뒤 측정값이 이 성분에 요구하는 값.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Edit machine</source>
      <translation>기계 편집</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Effect</source>
      <translation>효과</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_effect.py" />
      <source>Effect on or off</source>
      <translation>효과 켜기/끄기</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Effects</source>
      <translation>효과</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Empties the fields for another source</source>
      <translation>다른 원인을 위해 칸을 비웁니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/ranking.py" />
      <source>Error</source>
      <translation>오차</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Error across the face, + outwards</source>
      <translation>면에 수직인 오차, + 바깥쪽</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/analysis.py" />
      <source>Error map</source>
      <translation>오차 지도</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Error on readings that took no part in the fit, µm</source>
      <translation>피팅에 쓰지 않은 측정값의 오차, µm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Error that remains</source>
      <translation>남는 오차</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Error, µm</source>
      <translation>오차, µm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Errors</source>
      <translation>오차</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>Errors of random machines</source>
      <translation>임의의 기계들의 오차</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Errors that come from one cause follow a source: one rail gives straightness and pitch, one temperature lengthens three scales.</source>
      <translation>한 가지 원인에서 오는 오차는 원인을 따릅니다: 레일 하나가 진직도와 피치를 만들고, 온도 하나가 세 스케일을 늘립니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>Every point at its best place when all of them move; click to see</source>
      <translation>모두 옮길 때 각 점의 가장 좋은 위치; 클릭하면 보입니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_motion.py" />
      <source>Exaggeration</source>
      <translation>과장 배율</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Expected error</source>
      <translation>기대 오차</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/errormap.py" />
      <source>Expected error √(E[Y]² + V(Y))</source>
      <translation>기대 오차 √(E[Y]² + V(Y))</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/errormap.py" />
      <source>Expected error √E[Y]</source>
      <translation>예상 오차 √E[Y]</translation>
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
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Factor</source>
      <translation>계수</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>False names</source>
      <translation>거짓 이름</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Feature</source>
      <translation>형상</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Features that exceed it are marked; 0: no limit</source>
      <translation>초과하는 형상을 표시합니다. 0: 한계 없음</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>Figure</source>
      <translation>지표</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>Figures</source>
      <translation>지표</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Findings</source>
      <translation>발견</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Finds the cheapest tolerances that meet the target.</source>
      <translation>목표를 만족하는 가장 싼 공차를 찾습니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>First</source>
      <translation>첫 값</translation>
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
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Fit</source>
      <translation>피팅</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Fit of the declared errors alone</source>
      <translation>선언된 오차만의 피팅</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Fits the view to the residuals</source>
      <translation>잔차에 맞춰 화면을 조정합니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Fitting the declared errors</source>
      <translation>선언된 오차를 피팅하는 중</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tables.py" />
      <source>Folder for the compensation tables</source>
      <translation>보정 테이블 폴더</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_motion.py" />
      <source>Folder for the pictures</source>
      <translation>그림을 저장할 폴더</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/export.py" />
      <source>Folder for the report</source>
      <translation>보고서 폴더</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Folder for the trace</source>
      <translation>추적 결과 폴더</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Folder for the variants</source>
      <translation>변형 폴더</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Folder of the fleet</source>
      <translation>기계군 폴더</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Folder…</source>
      <translation>폴더…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tables.py" />
      <source>Format</source>
      <translation>형식</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Found again in half-samples</source>
      <translation>절반 표본에서 다시 발견</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>FreeCAD processes that compute variants beside each other</source>
      <translation>변형을 나란히 계산하는 FreeCAD 프로세스 수</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>From</source>
      <translation>부터</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>From 0 to 1, so that every machine has the same colours</source>
      <translation>0에서 1까지, 모든 기계가 같은 색상을 갖도록 함</translation>
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
      <location filename="../../sensworkbench/gui/task_motion.py" />
      <source>From a tenth to ten times of what fits the view</source>
      <translation>화면에 맞는 크기의 10분의 1에서 10배까지</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>From file…</source>
      <translation>파일에서…</translation>
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
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Gives the machine its former tolerances back</source>
      <translation>기계에 이전 공차를 되돌려 줍니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Gives the selected errors the limits ± this value</source>
      <translation>선택한 오차의 한계를 ± 이 값으로 합니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Grade</source>
      <translation>등급</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Grades of guides, screws and scales for straightness and positioning; the rest as before</source>
      <translation>진직도와 위치 결정에 대한 안내면, 볼나사, 스케일의 등급; 나머지는 전과 같음</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Greatest error that is allowed; what is tried passes or fails it</source>
      <translation>허용되는 최대 오차. 시험한 값이 합격인지 불합격인지 표시합니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Grid, positions per axis</source>
      <translation>격자, 축당 위치 수</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Gross outliers</source>
      <translation>큰 이상값</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Gross outliers, left out</source>
      <translation>제외한 큰 이상값</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/guide.py" />
      <source>Guide of Sens Workbench</source>
      <translation>Sens Workbench 안내서</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_assembly.py" />
      <source>Held by nothing, left out: {names}</source>
      <translation>고정되지 않아 제외됨: {names}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Hidden by the declared errors in this plan</source>
      <translation>이 계획에서 선언된 오차에 가려지는 것</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Hides the machine while the panel is open</source>
      <translation>패널이 열려 있는 동안 기계를 숨깁니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Holds a folder for each machine, with machine.json and measured.csv</source>
      <translation>기계마다 machine.json과 measured.csv가 든 폴더를 담고 있음</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_jog.py" />
      <source>Home</source>
      <translation>원점</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>How far a point may be moved from where it is; the view shows this box</source>
      <translation>점을 현재 위치에서 옮길 수 있는 거리; 화면에 이 상자가 보입니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>How it is shown</source>
      <translation>표시 방법</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>How much larger than it is the error is drawn; left: not at all</source>
      <translation>오차를 실제보다 얼마나 크게 그릴지. 왼쪽: 그리지 않음</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>How the largest share of the feature moves the machine</source>
      <translation>형상에 가장 크게 기여하는 오차가 기계를 움직이는 모습</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Ideal part beside</source>
      <translation>이상 형상을 옆에</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>Import readings</source>
      <translation>측정값 가져오기</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Import tolerances</source>
      <translation>공차 가져오기</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>Import {name}</source>
      <translation>{name} 가져오기</translation>
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
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>Judged</source>
      <translation>판정</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Judges the faces that the tool path cuts</source>
      <translation>공구 경로가 깎는 면을 판정합니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Judging the faces that the tool path cuts</source>
      <translation>공구 경로가 깎는 면을 판정하는 중</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Keep</source>
      <translation>보관</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Keeps what is tried in a list, to compare it with others</source>
      <translation>시도한 내용을 목록에 보관해 다른 것과 비교합니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/scenarios.py" />
      <source>Kept</source>
      <translation>보관됨</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>Largest total index Sᵀ of the component</source>
      <translation>구성요소의 최대 전체 지수 Sᵀ</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Latin hypercube</source>
      <translation>라틴 하이퍼큐브</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Law</source>
      <translation>분포</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/proposal_note.py" />
      <source>Leaves the question open</source>
      <translation>질문을 남겨 둡니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Legend</source>
      <translation>범례</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Lets the errors follow the source, one undo step</source>
      <translation>오차가 원인을 따르게 합니다(실행 취소 한 단계)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Limit</source>
      <translation>한계</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>Limits of the error</source>
      <translation>오차의 한계</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Limits of the source, a pure number; each error is its factor times it</source>
      <translation>원인(순수한 수)의 한계; 각 오차는 계수 곱하기 이 수입니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Line</source>
      <translation>줄</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Look of the result</source>
      <translation>결과의 모양</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/proposal_note.py" />
      <source>Looking at shapes: %p %</source>
      <translation>모양을 살펴보는 중: %p %</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>Looking at the plan</source>
      <translation>계획을 검토하는 중</translation>
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
      <location filename="../../sensworkbench/gui/examples.py" />
      <source>Machine</source>
      <translation>기계</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_assembly.py" />
      <source>Machine from assembly</source>
      <translation>조립체에서 기계 만들기</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Machine from selection</source>
      <translation>선택에서 기계 만들기</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Machines</source>
      <translation>기계</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Magma (black to pale yellow)</source>
      <translation>Magma (검정에서 옅은 노랑)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Makes the found effects objects under their bodies, one undo step</source>
      <translation>발견된 효과를 해당 부분 아래의 객체로 만듭니다(실행 취소 한 단계)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/ranking.py" />
      <source>Meaning</source>
      <translation>의미</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Measure {name} further: it holds {part} % of what remains uncertain. rms of that: {rms} µm.</source>
      <translation>{name}을(를) 더 측정하십시오: 남은 불확도의 {part} %가 여기에 있습니다. 그 rms: {rms} µm.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>Median</source>
      <translation>중앙값</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Median, µm</source>
      <translation>중앙값, µm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_repair.py" />
      <source>Mends every row with a tick, as one undo step</source>
      <translation>체크 표시된 모든 행을 한 번의 실행 취소 단계로 고칩니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_motion.py" />
      <source>Motion of {name}</source>
      <translation>{name}의 움직임</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>Move reference points</source>
      <translation>기준점 옮기기</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Move the scale of</source>
      <translation>스케일 이동 축</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trial.py" />
      <source>Moves one axis after the other to the ends of its travel and back</source>
      <translation>축을 하나씩 이송 범위의 양 끝까지 움직였다가 되돌립니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trial.py" />
      <source>Moves the axis within its travel; it goes back when you let go</source>
      <translation>이송 범위 안에서 축을 움직입니다. 놓으면 되돌아갑니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>Moves the chosen reference points, one undo step</source>
      <translation>선택한 기준점을 옮깁니다(실행 취소 한 단계)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Moves the reference point of an axis, where its scale is read, along X, Y, Z</source>
      <translation>스케일을 읽는 축의 기준점을 X, Y, Z 방향으로 옮깁니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Moves the slice along its axis</source>
      <translation>단면을 축을 따라 옮깁니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_jog.py" />
      <source>Moves the tool to the place that was clicked in the 3D view</source>
      <translation>3D 뷰에서 클릭한 위치로 공구를 옮깁니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>Moving every point</source>
      <translation>모든 점을 옮겨 보는 중</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Name</source>
      <translation>이름</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Needs</source>
      <translation>필요한 것</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>New</source>
      <translation>새로</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Next</source>
      <translation>다음</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>No effect is named.</source>
      <translation>이름 붙인 효과가 없습니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>No extent, not in the ranking: {effects}</source>
      <translation>범위가 없어 순위에서 제외됨: {effects}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>No further measurement is needed to tell the findings apart.</source>
      <translation>발견을 구별하기 위한 추가 측정이 필요 없습니다.</translation>
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
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>No rival: nothing else that was searched explains as much.</source>
      <translation>경쟁 후보 없음: 탐색한 다른 어떤 것도 이만큼 설명하지 못합니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>Noise</source>
      <translation>잡음</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Noise of one reading {noise} µm</source>
      <translation>측정값 하나의 잡음 {noise} µm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/proposal_note.py" />
      <source>Not looked at yet: {names}</source>
      <translation>아직 확인하지 않음: {names}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>Not moved, because it belongs to a part: {names}</source>
      <translation>부품에 속하므로 옮기지 않음: {names}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Not square as designed: {pairs}</source>
      <translation>설계상 직각이 아님: {pairs}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Not testable: a column is missing</source>
      <translation>검정 불가: 열이 없음</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Not told apart by this plan</source>
      <translation>이 계획으로 구별할 수 없는 것</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Not traced yet.</source>
      <translation>아직 추적하지 않았습니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_repair.py" />
      <source>Nothing is wrong with the machine's objects.</source>
      <translation>기계 객체에 이상이 없습니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Nothing was noticed while reading</source>
      <translation>읽는 동안 특이 사항 없음</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>Noticed while reading:</source>
      <translation>읽는 동안 발견한 사항:</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Now</source>
      <translation>지금</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Number of variants</source>
      <translation>변형의 수</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/objective_form.py" />
      <source>Objective</source>
      <translation>목적 함수</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/messages.py" />
      <source>Objects of this document are damaged: Sens &gt; Repair Machine… mends them.</source>
      <translation>이 문서의 객체가 손상되었습니다: Sens &gt; 기계 복구…로 고칠 수 있습니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Of the fit</source>
      <translation>적합의 것</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>One inch</source>
      <translation>1인치</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>One millimetre</source>
      <translation>1밀리미터</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>One position</source>
      <translation>한 위치</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/messages.py" />
      <source>Open the folder</source>
      <translation>폴더 열기</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/messages.py" />
      <source>Open the report</source>
      <translation>보고서 열기</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Opens the page with all variants and the Pareto front</source>
      <translation>모든 변형과 파레토 경계가 있는 페이지를 엽니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Open…</source>
      <translation>열기…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>Order of the axes</source>
      <translation>축 순서</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/objective_form.py" />
      <source>Orientation of the tool</source>
      <translation>공구의 자세</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/analysis.py" />
      <source>Original colours</source>
      <translation>원래 색상</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Otherwise the source takes the place of the tolerances of its errors</source>
      <translation>아니면 원인이 그 오차들의 공차를 대신합니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>Out of date</source>
      <translation>오래됨</translation>
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
      <location filename="../../sensworkbench/gui/objective_form.py" />
      <source>Output</source>
      <translation>출력</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>Over a grid of {counts} positions</source>
      <translation>{counts}개 위치의 격자</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_motion.py" />
      <source>Over the readings {name}</source>
      <translation>측정값 {name}에 따라</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>Over the workspace, {counts} positions</source>
      <translation>작업 공간 전체, {counts}개 위치</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Parameter</source>
      <translation>매개변수</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Parameters</source>
      <translation>매개변수</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Parameters (–: not determined)</source>
      <translation>매개변수 (–: 결정되지 않음)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Pareto front</source>
      <translation>파레토 경계</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Park &amp; Yang's values for all errors</source>
      <translation>모든 오차에 Park &amp; Yang의 값</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Part alone</source>
      <translation>공작물만</translation>
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
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Picture</source>
      <translation>그림</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Picture…</source>
      <translation>그림…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>Places</source>
      <translation>측정 위치</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>Places of the plan</source>
      <translation>계획의 측정 위치</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>Plan the measurement</source>
      <translation>측정 계획</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>Point</source>
      <translation>점</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Points</source>
      <translation>점</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Position</source>
      <translation>위치</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/objective_form.py" />
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
      <location filename="../../sensworkbench/gui/prices.py" />
      <source>Prices of tolerances</source>
      <translation>공차의 가격</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>Probability</source>
      <translation>확률</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>Programmed positions are those of the tool on the workpiece</source>
      <translation>프로그램 위치는 공작물에 대한 공구의 위치입니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>Puts the reference points back</source>
      <translation>기준점을 되돌립니다</translation>
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
      <location filename="../../sensworkbench/gui/task_motion.py" />
      <source>Reading the tool path</source>
      <translation>공구 경로를 읽는 중</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Readings</source>
      <translation>측정값</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Reads a covariance: names of errors in the first row and column, µm and µrad</source>
      <translation>공분산을 읽습니다: 첫 행과 첫 열에 오차 이름, µm와 µrad</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Reads a sweep.json, to change it or to go on where it was cancelled</source>
      <translation>sweep.json을 읽어 바꾸거나 취소한 곳부터 계속합니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Reads prices: symbol, kind, c, k, lower, upper, or grades (see Allocation)</source>
      <translation>가격을 읽습니다: symbol, kind, c, k, lower, upper 또는 등급(Allocation 참조)</translation>
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
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Records</source>
      <translation>기록</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Reference from</source>
      <translation>기준점 출처</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Reference point: {vector} ({source})</source>
      <translation>기준점: {vector} ({source})</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/pointers.py" />
      <source>Reference {name}</source>
      <translation>기준점 {name}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Remove</source>
      <translation>제거</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Remove effects</source>
      <translation>효과 제거</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Remove source</source>
      <translation>원인 제거</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_repair.py" />
      <source>Repair</source>
      <translation>복구</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_repair.py" />
      <source>Repair Machine…</source>
      <translation>기계 복구…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_repair.py" />
      <source>Repair machine</source>
      <translation>기계 복구</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Report</source>
      <translation>보고서</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Report…</source>
      <translation>보고서…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/residuals.py" />
      <source>Residual of held-out readings</source>
      <translation>남겨 둔 측정값의 잔차</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Residuals</source>
      <translation>잔차</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Residuals as arrows in the workspace, all on one scale</source>
      <translation>작업 공간의 잔차 화살표, 모두 같은 축척</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Result</source>
      <translation>결과</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Reversed</source>
      <translation>반대로</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Rival</source>
      <translation>경쟁 후보</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>Room</source>
      <translation>여유</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Run…</source>
      <translation>실행…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/copying.py" />
      <source>Save as CSV…</source>
      <translation>CSV로 저장…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>Save mapping</source>
      <translation>열 지정 저장</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>Save mapping…</source>
      <translation>열 지정 저장…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/export.py" />
      <source>Save picture</source>
      <translation>그림 저장</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_motion.py" />
      <source>Save pictures…</source>
      <translation>그림 저장…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/copying.py" />
      <source>Save table</source>
      <translation>표 저장</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Saves the 3D view with its legend</source>
      <translation>범례와 함께 3D 화면을 저장합니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>Says how large the error of a machine within these tolerances may become, how often it exceeds a limit, and what makes it large.</source>
      <translation>이 공차 안에 있는 기계의 오차가 얼마나 커질 수 있는지, 얼마나 자주 한계를 넘는지, 무엇이 크게 하는지 알려 줍니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>Says what a move of each scale, guide block and of the tool by one millimetre is worth, and where each is best within the room.</source>
      <translation>각 스케일, 안내 블록, 공구를 1밀리미터 옮길 때의 효과와 여유 안에서 가장 좋은 위치를 알려 줍니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>Says, before anything is measured, how well each declared error will be known.</source>
      <translation>측정 전에 선언된 각 오차를 얼마나 정확히 알게 될지 알려 줍니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Scatter of one reading, µm</source>
      <translation>측정값 하나의 산포, µm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Searches for an effect that explains what the declared errors leave</source>
      <translation>선언된 오차가 남긴 것을 설명하는 효과를 찾습니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Searching</source>
      <translation>탐색 중</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_assembly.py" />
      <source>Select a coordinate system, vertex, edge or face at the tool's tip</source>
      <translation>공구 끝의 좌표계, 꼭짓점, 모서리 또는 면을 선택하십시오</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_repair.py" />
      <source>Sens &gt; Repair Machine… lists all of them and mends them. Their data are kept.</source>
      <translation>Sens &gt; 기계 복구…에서 모두 확인하고 고칠 수 있습니다. 데이터는 유지됩니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/analysis.py" />
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
      <location filename="../../sensworkbench/gui/task_effect.py" />
      <source>Shape</source>
      <translation>형태</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>Share</source>
      <translation>몫</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Share now</source>
      <translation>현재 몫</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Share of false effects among those that stand (false discovery rate)</source>
      <translation>인정된 효과 중 거짓의 비율(거짓 발견율)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>Share of the component in the variance</source>
      <translation>분산에서 구성 요소의 몫</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>Share of the variance, 0 to 1</source>
      <translation>분산에서 차지하는 비율, 0~1</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Share of the variance; all shares add to 1</source>
      <translation>분산의 몫; 모두 더하면 1</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Share then</source>
      <translation>이후 몫</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Shares of the components</source>
      <translation>구성 요소의 몫</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Shares of the components when errors vary together. With the covariance of a fit they say which further measurement helps most.</source>
      <translation>오차가 함께 변할 때 구성 요소의 몫입니다. 적합의 공분산이면 어떤 추가 측정이 가장 도움이 되는지 알려 줍니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Show</source>
      <translation>표시</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Show Motion</source>
      <translation>움직임 보기</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/ranking.py" />
      <source>Show only: Z, squareness, Spindle …</source>
      <translation>이것만 표시: Z, 직각도, 스핀들 …</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/ranking.py" />
      <source>Shows the errors whose name, component or meaning has these words</source>
      <translation>이름, 구성 요소 또는 의미에 이 단어가 있는 오차를 표시합니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Significant, but not named</source>
      <translation>유의하지만 이름 붙이지 않음</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Size</source>
      <translation>크기</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/proposal_note.py" />
      <source>Skip</source>
      <translation>건너뛰기</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Slice at {axis}</source>
      <translation>{axis} 단면</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Sobol' points</source>
      <translation>소볼 점</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Source</source>
      <translation>원인</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Sources</source>
      <translation>원인</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Sources: {n}. Compute gives their shares in the ranking.</source>
      <translation>원인: {n}. 계산하면 순위에 몫이 나옵니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Specification of a sweep</source>
      <translation>변형 계산 지정 파일</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>Spindle and tool</source>
      <translation>주축과 공구</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/move_arrows.py" />
      <source>Spindle reference</source>
      <translation>스핀들 기준점</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>Squareness</source>
      <translation>직각도</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>Standard uncertainty of one reading</source>
      <translation>측정값 하나의 표준 불확도</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>Standard uncertainty of the error's function, rms over the travel</source>
      <translation>오차 함수의 표준 불확도, 이송 범위의 rms</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Start over</source>
      <translation>처음부터</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Steps</source>
      <translation>단계</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/live.py" />
      <source>Stopping…</source>
      <translation>멈추는 중…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/proposal_note.py" />
      <source>Stops the look and keeps what is known by now</source>
      <translation>살펴보기를 멈추고 지금까지 알아낸 것을 남깁니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Stops; the old result stays</source>
      <translation>중지합니다. 이전 결과는 그대로입니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/proposal_note.py" />
      <source>Structure</source>
      <translation>구조</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Structure (workpiece → tool, F: bed)</source>
      <translation>구조 (공작물 → 공구, F: 베드)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_assembly.py" />
      <source>Structure: {code}</source>
      <translation>구조: {code}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Suggested</source>
      <translation>제안</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_motion.py" />
      <source>Swing between the ends</source>
      <translation>양 끝 사이의 왕복</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>Tables (*.csv *.txt *.tsv);;All files (*)</source>
      <translation>표 (*.csv *.txt *.tsv);;모든 파일 (*)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/sources.py" />
      <source>Take</source>
      <translation>사용</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Take selection</source>
      <translation>선택 사용</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>Taken as</source>
      <translation>용도</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_effect.py" />
      <source>Takes part in the errors of the machine</source>
      <translation>기계 오차에 포함</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/sources.py" />
      <source>Takes the coordinate system, datum, edge, face or part that is selected</source>
      <translation>선택한 좌표계, 데이텀, 모서리, 면 또는 부품을 사용합니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Takes the found effects out of the machine again</source>
      <translation>발견된 효과를 기계에서 다시 뺍니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Takes the source away, one undo step; its errors get tolerances of the same width</source>
      <translation>원인을 제거합니다(실행 취소 한 단계). 그 오차들은 같은 폭의 공차를 얻습니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Takes what the last fit leaves uncertain</source>
      <translation>마지막 적합이 남긴 불확도를 씁니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Target</source>
      <translation>목표</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Tells apart: {what}</source>
      <translation>구별 대상: {what}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>The document takes this point from a part. Move the part, or choose another point in Edit Machine; the results follow.</source>
      <translation>이 점은 문서의 부품에서 가져옵니다. 부품을 옮기거나 기계 편집에서 다른 점을 고르십시오. 결과가 따라갑니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>The error that the tolerances together may cause</source>
      <translation>모든 공차가 함께 일으켜도 되는 오차</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>The file does not say what its signs mean. Answer the questions, then import.</source>
      <translation>파일에 부호의 의미가 없습니다. 질문에 답한 뒤 가져오십시오.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>The file says so in line {line}.</source>
      <translation>파일 {line}번째 줄에 적혀 있습니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>The first {n} are shown.</source>
      <translation>처음 {n}개를 표시합니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>The fit stopped: {error}. The report view holds the details; please send them in with the readings.</source>
      <translation>맞춤이 중단되었습니다: {error}. 자세한 내용은 보고서 창에 있습니다. 측정값과 함께 보내 주십시오.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>The largest error that is allowed; each figure passes or fails it</source>
      <translation>허용되는 가장 큰 오차; 각 지표가 합격하거나 불합격합니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>The machine has changed since this trace. Trace again.</source>
      <translation>추적 뒤 기계가 바뀌었습니다. 다시 추적하십시오.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_study.py" />
      <source>The machine has changed since: compute again.</source>
      <translation>그 뒤 기계가 바뀌었습니다: 다시 계산하십시오.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_assembly.py" />
      <source>The middle of the far end was taken for the side.</source>
      <translation>옆면 대신 먼 쪽 끝의 중심을 사용했습니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>The order of the axes is how the parts carry each other: rebuild the parts, then choose the structure in Edit Machine.</source>
      <translation>축 순서는 부품이 서로를 받치는 방식입니다. 부품을 다시 구성한 뒤 기계 편집에서 구조를 고르십시오.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>The part of all errors, or of all machines, that is below a figure</source>
      <translation>지표보다 작은 모든 오차 또는 모든 기계의 비율</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>The part of the corrected program, in the same colours; needs fitted errors or effects</source>
      <translation>보정된 프로그램의 공작물을 같은 색으로 표시합니다. 맞춘 오차나 효과가 필요합니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>The part that {name} makes</source>
      <translation>{name}의 공작물</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>The parts selected in the view or the tree become this component</source>
      <translation>화면이나 트리에서 선택한 부품이 이 구성요소가 됩니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>The positions are</source>
      <translation>위치는</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>The readings are</source>
      <translation>측정값은</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>The reference points are moved; Undo puts them back</source>
      <translation>기준점을 옮겼습니다; 되돌리면 원래대로 됩니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>The same for the readings of the fit, µm</source>
      <translation>피팅에 쓴 측정값의 오차, µm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>The same if every place is measured again in another run</source>
      <translation>모든 위치를 다른 회차에서 다시 측정할 때의 값</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>The same if every place is measured again with a tool of another length</source>
      <translation>모든 위치를 길이가 다른 공구로 다시 측정할 때의 값</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>The same if every place is measured in the directions that the plan lacks</source>
      <translation>계획에 없는 방향으로도 모든 위치를 측정할 때의 값</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>The same would cost least at the tolerance of {symbol}: {price} per µm².</source>
      <translation>같은 효과는 {symbol} 공차에서 가장 쌉니다: µm²당 {price}.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_assembly.py" />
      <source>The sliders between bed and tool; the others carry the workpiece</source>
      <translation>베드와 공구 사이의 슬라이더. 나머지는 공작물을 지지합니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>The table has the columns of the readings, without readings</source>
      <translation>표는 측정값의 열을 가지며 측정값은 없습니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>The tolerances are those of the table; Undo gives the former ones back</source>
      <translation>공차가 표의 값으로 바뀌었습니다. 되돌리기로 이전 값을 복원합니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_assembly.py" />
      <source>The tool is carried by</source>
      <translation>공구를 지지하는 슬라이더</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_assembly.py" />
      <source>The tool reaches {length} past this point.</source>
      <translation>공구가 이 점보다 {length} 더 나와 있습니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>The trace stopped: {error}. Nothing was changed. The report view holds the details; please send them in with the readings.</source>
      <translation>추적이 중단되었습니다: {error}. 변경된 것은 없습니다. 자세한 내용은 보고서 창에 있습니다. 측정값과 함께 보내 주십시오.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_jog.py" />
      <source>The travel ends {distance} from the clicked point.</source>
      <translation>이송 범위가 클릭한 점에서 {distance} 떨어진 곳에서 끝납니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Then</source>
      <translation>이후</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>These readings cannot tell it from its rivals:</source>
      <translation>이 측정값으로는 다음 후보와 구별할 수 없습니다:</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>They are the motion of</source>
      <translation>측정한 운동은</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>This is the middle of a side, not its end: take it again.</source>
      <translation>옆면의 중심이며 끝이 아닙니다. 다시 가져오십시오.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>This point is at its best place already.</source>
      <translation>이 점은 이미 가장 좋은 위치에 있습니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Tick the errors that follow the source; double click a factor to change it</source>
      <translation>원인을 따르는 오차를 체크하십시오. 계수를 두 번 클릭하면 바꿀 수 있습니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>To</source>
      <translation>방향</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_jog.py" />
      <source>To clicked point</source>
      <translation>클릭한 점으로</translation>
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
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Tolerance of the selected errors, ± this value; Enter sets it</source>
      <translation>선택한 오차의 공차, ± 이 값. Enter 키로 적용</translation>
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
      <location filename="../../sensworkbench/gui/move_arrows.py" />
      <source>Tool point</source>
      <translation>공구점</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>Total index Sᵀ of the component</source>
      <translation>구성요소의 전체 지수 Sᵀ</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Total index Sᵀ with the effects in the machine</source>
      <translation>효과를 포함한 기계의 전체 지수 Sᵀ</translation>
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
      <source>Total index: the share of the variance with all interactions; they add to more than 1</source>
      <translation>총 지수: 모든 상호작용을 포함한 분산의 몫; 합은 1보다 큽니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Trace</source>
      <translation>추적</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Trace all</source>
      <translation>모두 추적</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Trace of {name}</source>
      <translation>{name} 추적</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Traces every record by the same rules: which effect recurs where.</source>
      <translation>모든 기록을 같은 규칙으로 추적합니다: 어느 효과가 어디에서 되풀이되는지.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Tracing {n} records</source>
      <translation>기록 {n}개를 추적하는 중</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Travel</source>
      <translation>이송 범위</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trial.py" />
      <source>Try it</source>
      <translation>움직여 보기</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Try many designs</source>
      <translation>여러 설계 시험</translation>
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
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>Uncertainties</source>
      <translation>불확도</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Undo</source>
      <translation>되돌리기</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/proposal_note.py" />
      <source>Undo answer</source>
      <translation>답 되돌리기</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>Unit</source>
      <translation>단위</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Unit in which all angles are shown</source>
      <translation>모든 각도를 표시하는 단위</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Units</source>
      <translation>단위</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Up to</source>
      <translation>까지</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Upper</source>
      <translation>상한</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/errormap.py" />
      <source>Upper estimate |E[Y]| + 2√V(Y)</source>
      <translation>상한 추정 |E[Y]| + 2√V(Y)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/errormap.py" />
      <source>Upper estimate √(E[Y] + 2√V(Y))</source>
      <translation>상한 추정 √(E[Y] + 2√V(Y))</translation>
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
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Usual size</source>
      <translation>일반적인 크기</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Value</source>
      <translation>값</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Values</source>
      <translation>값</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>Variance-weighted total index Sᵀ</source>
      <translation>분산 가중 전체 지수 Sᵀ</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Variants</source>
      <translation>변형</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Vary</source>
      <translation>변경 대상</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Verdict</source>
      <translation>판정</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/preferences.py" />
      <source>Viridis (purple to yellow)</source>
      <translation>Viridis (보라에서 노랑)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/objective_form.py" />
      <source>Weight of each component; 0 leaves it out (a groove does not care along its length)</source>
      <translation>각 성분의 가중치; 0이면 제외합니다 (홈은 길이 방향 오차와 무관합니다)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/objective_form.py" />
      <source>Weights</source>
      <translation>가중치</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Were all errors normal, nothing would be cheaper than {bound}.</source>
      <translation>모든 오차가 정규 분포라면 {bound}보다 싼 것은 없습니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>What</source>
      <translation>항목</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>What each column of the table is:</source>
      <translation>표의 각 열이 나타내는 것:</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>What if</source>
      <translation>가정 분석</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>What is computed for each variant</source>
      <translation>각 변형에 대해 계산할 값</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>What is judged</source>
      <translation>평가 대상</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>What is left</source>
      <translation>남은 것</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>What makes it large</source>
      <translation>크게 하는 것</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>What recurs</source>
      <translation>되풀이되는 것</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>What the declared errors leave depends on {columns}.</source>
      <translation>선언된 오차가 남긴 것은 {columns}에 의존합니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/ranking.py" />
      <source>What the error contributes to the variance, (S + Sᵀ)/2: the shares add to 100 %. Work on the largest first</source>
      <translation>오차가 분산에 기여하는 양, (S + Sᵀ)/2: 몫의 합은 100 %. 가장 큰 것부터 개선하십시오</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/analysis.py" />
      <source>What the map shows is chosen in the review, under Settings</source>
      <translation>지도에 표시할 내용은 검토 창의 설정에서 고릅니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>What the readings mean</source>
      <translation>측정값의 의미</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tables.py" />
      <source>What these files hold, and what they cannot:</source>
      <translation>이 파일에 담기는 것과 담을 수 없는 것:</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>What to do</source>
      <translation>할 일</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>What to measure next</source>
      <translation>다음에 측정할 것</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>When a table moves to +X, the tool moves to −X on the workpiece</source>
      <translation>테이블이 +X로 가면 공구는 공작물에서 −X로 움직입니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Where the number stands: joints.Z.point.2, Spreadsheet.reach, Box.Length</source>
      <translation>수치의 위치: joints.Z.point.2, Spreadsheet.reach, Box.Length</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>Where to move</source>
      <translation>어디로 옮길까</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Who makes it</source>
      <translation>원인</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Why it carries no name</source>
      <translation>이름을 붙이지 않은 이유</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>Why it remains</source>
      <translation>남는 이유</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>With the corrected program</source>
      <translation>보정된 프로그램으로</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/residuals.py" />
      <source>With the found effects</source>
      <translation>발견된 효과 포함</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Workers</source>
      <translation>작업자</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>Workpiece and fixture</source>
      <translation>공작물과 고정구</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/move_arrows.py" />
      <source>Workpiece reference</source>
      <translation>공작물 기준점</translation>
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
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>Worst place</source>
      <translation>가장 나쁜 위치</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>Worst place: {size}</source>
      <translation>가장 나쁜 위치: {size}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tables.py" />
      <source>Write files…</source>
      <translation>파일 쓰기…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review.py" />
      <source>Writes HTML, JSON and CSV</source>
      <translation>HTML, JSON, CSV를 씁니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Writes features, shares and pictures of the part</source>
      <translation>형상, 기여율, 공작물 그림을 기록합니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_motion.py" />
      <source>Writes the motion as an animated GIF and as numbered PNG pictures</source>
      <translation>움직임을 애니메이션 GIF와 번호가 붙은 PNG 그림으로 기록합니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tables.py" />
      <source>Writes the tables and this statement into a folder</source>
      <translation>테이블과 이 설명을 폴더에 씁니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Writes the tolerances to the machine, one undo step</source>
      <translation>공차를 기계에 기록합니다. 되돌리기 한 단계</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>Writes the tolerances, weights and moved scales to the machine, one undo step</source>
      <translation>공차, 가중치, 옮긴 스케일을 기계에 기록합니다(실행 취소 한 단계)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Writes the tolerances, what other targets cost, and a report</source>
      <translation>공차, 다른 목표의 비용, 보고서를 기록합니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>Writes these choices to a file for the command line's --mapping</source>
      <translation>명령줄 --mapping에 쓸 파일로 저장합니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Writes tolerances as CSV or JSON</source>
      <translation>공차를 CSV나 JSON으로 씁니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Writes trace.json, report.html and the augmented machine</source>
      <translation>trace.json, report.html과 확장된 기계를 저장합니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Writes what was found as a page, and as JSON and CSV</source>
      <translation>결과를 문서 페이지와 JSON, CSV로 기록합니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/messages.py" />
      <source>Written to {folder}:</source>
      <translation>{folder}에 기록됨:</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/copying.py" />
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
      <source>Y: square of the orientation error of the tool</source>
      <translation>Y: 공구 자세 오차의 제곱</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>Y: square of the position error of the tool</source>
      <translation>Y: 공구 위치 오차의 제곱</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>Z carriage</source>
      <translation>Z 이송체</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Zoom</source>
      <translation>확대</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_assembly.py" />
      <source>a coordinate system named TCP or tool tip, if there is one</source>
      <translation>이름이 TCP 또는 공구 끝인 좌표계(있는 경우)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>a list</source>
      <translation>목록</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>a quarter</source>
      <translation>4분의 1</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>after</source>
      <translation>후</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>also turns what the guide carries</source>
      <translation>안내면이 나르는 것도 회전시킴</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>approach along {axis}</source>
      <translation>{axis} 접근 방향</translation>
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
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>as programmed</source>
      <translation>프로그램된 값</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/sources.py" />
      <source>at its centre of mass</source>
      <translation>무게 중심</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/sources.py" />
      <source>at its placement</source>
      <translation>배치 위치</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>at most</source>
      <translation>최대</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>bed</source>
      <translation>베드</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>before</source>
      <translation>전</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>before and after</source>
      <translation>전과 후</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>catalogue, relative costs</source>
      <translation>목록, 상대 비용</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>cells, properties</source>
      <translation>셀, 속성</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>chosen</source>
      <translation>선택</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>compensation values: commanded minus actual</source>
      <translation>보정값: 지령값 − 실제값</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>cylindricity</source>
      <translation>원통도</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>declared</source>
      <translation>선언 오차</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>direction of sensing {axis}</source>
      <translation>측정 방향 {axis}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>distance</source>
      <translation>거리</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>doubled</source>
      <translation>두 배</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>driver, as it is</source>
      <translation>구동 변수(그대로)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>effect as fitted</source>
      <translation>피팅된 효과</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/messages.py" />
      <source>en</source>
      <translation>ko</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>error along {axis}</source>
      <translation>{axis} 방향 오차</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>error of a held-out point, µm</source>
      <translation>남겨 둔 점의 오차, µm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>errors: actual minus commanded</source>
      <translation>오차: 실제값 − 지령값</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>every combination</source>
      <translation>모든 조합</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>exceeds its limit</source>
      <translation>한계를 초과합니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/scenarios.py" />
      <source>fails</source>
      <translation>불합격</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>feed</source>
      <translation>이송 속도</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>fixed value</source>
      <translation>고정값</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>flatness</source>
      <translation>평면도</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/pointers.py" />
      <source>for +{name} the table moves to −{name}</source>
      <translation>+{name}일 때 테이블은 −{name} 방향으로 이동</translation>
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
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>from a table</source>
      <translation>표에서</translation>
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
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>halving a tolerance doubles its cost</source>
      <translation>공차를 반으로 줄이면 비용이 두 배</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>ignored</source>
      <translation>무시</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/sources.py" />
      <source>its local X</source>
      <translation>로컬 X</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/sources.py" />
      <source>its local Y</source>
      <translation>로컬 Y</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/sources.py" />
      <source>its local Z</source>
      <translation>로컬 Z</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>largest</source>
      <translation>최대</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>largest share then: {name}, {value}</source>
      <translation>이후 가장 큰 몫: {name}, {value}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>load</source>
      <translation>하중</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>no folder yet</source>
      <translation>아직 폴더 없음</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>no index</source>
      <translation>지수 없음</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>none</source>
      <translation>없음</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>none: moves are shown without their worth</source>
      <translation>없음: 이동의 가치는 보이지 않습니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>none: read a file, or fit readings first</source>
      <translation>없음: 파일을 읽거나 먼저 측정값을 적합하십시오</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>normal (limits ±3σ)</source>
      <translation>정규 (한계 ±3σ)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>not cut by the path</source>
      <translation>경로가 깎지 않음</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>not determined</source>
      <translation>결정되지 않음</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>nothing</source>
      <translation>없음</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>numbers of the machine</source>
      <translation>기계의 수치</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>of the fit: what remains uncertain</source>
      <translation>적합의 것: 남은 불확도</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>of the table, X and Y counted its way</source>
      <translation>테이블 기준(X, Y를 테이블 방향으로)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>off</source>
      <translation>끄기</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/display.py" />
      <source>one position</source>
      <translation>한 위치</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>p up to {limit} stands; every p comes from {count} exchanges.</source>
      <translation>p가 {limit} 이하면 인정되며, 모든 p는 교환 {count}번에서 나옵니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>parallelism</source>
      <translation>평행도</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/scenarios.py" />
      <source>passes</source>
      <translation>합격</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>perpendicularity</source>
      <translation>직각도</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>points</source>
      <translation>점</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>position</source>
      <translation>위치도</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>position {axis}</source>
      <translation>{axis} 위치</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>range of the deviation along this body diagonal (ISO 230-6); click to see it</source>
      <translation>이 체대각선을 따른 편차의 범위(ISO 230-6); 클릭하면 보입니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>range over the workspace of the error along {axis} (ISO 230-1)</source>
      <translation>작업 공간에서 {axis} 방향 오차의 범위(ISO 230-1)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>reading along its direction</source>
      <translation>측정 방향의 값</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>readings</source>
      <translation>측정값</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>refused</source>
      <translation>거부됨</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>rivals that these readings cannot tell from it: {n}</source>
      <translation>이 측정값으로 구별할 수 없는 경쟁 후보: {n}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>rms at the worst place</source>
      <translation>가장 나쁜 위치의 rms</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>rms over the workspace</source>
      <translation>작업 공간 전체의 rms</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>rms {before} → {after} µm, at the worst place {worst_before} → {worst_after} µm.</source>
      <translation>rms {before} → {after} µm, 가장 나쁜 위치 {worst_before} → {worst_after} µm.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>rms {now} µm; best single move: {name}, {then} µm; all but the tool: {all} µm.</source>
      <translation>rms {now} µm; 가장 좋은 단일 이동: {name}, {then} µm; 공구를 뺀 모두: {all} µm.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>rms, µm</source>
      <translation>rms, µm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>roundness</source>
      <translation>진원도</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>run</source>
      <translation>회차</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>scale moved</source>
      <translation>스케일 이동</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>scale of {name} moved by {offset}</source>
      <translation>{name} 스케일을 {offset} 옮김</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/errormap.py" />
      <source>slice at {axis} = {position}</source>
      <translation>{axis} = {position} 단면</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>spindle speed</source>
      <translation>스핀들 속도</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>squareness carried</source>
      <translation>직각도가 함께 전달됨</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>squareness tilts the direction (ISO)</source>
      <translation>직각도는 방향만 기울임 (ISO)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>standard uncertainty</source>
      <translation>표준 불확도</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>straightness</source>
      <translation>진직도</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>such as rail of Y</source>
      <translation>예: Y 레일</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>suggested</source>
      <translation>제안</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>temperature</source>
      <translation>온도</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_assembly.py" />
      <source>the bed (no slider)</source>
      <translation>베드(슬라이더 없음)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>the first part</source>
      <translation>첫째 부품</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>the largest of V_X, V_Y and V_Z (ISO 230-1)</source>
      <translation>V_X, V_Y, V_Z 중 가장 큰 값(ISO 230-1)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>the largest of the diagonal deviations (ISO 230-6)</source>
      <translation>대각선 편차 중 가장 큰 값(ISO 230-6)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>the parts</source>
      <translation>부품</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>the table relative to the tool</source>
      <translation>공구에 대한 테이블</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>the tool relative to the workpiece</source>
      <translation>공작물에 대한 공구</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/review_settings.py" />
      <source>tilts the motion (ISO 230-1)</source>
      <translation>운동을 기울임 (ISO 230-1)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>time</source>
      <translation>시간</translation>
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
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>tool offset {axis}</source>
      <translation>공구 오프셋 {axis}</translation>
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
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>u</source>
      <translation>u</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>uncertainty</source>
      <translation>불확도</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>uncertainty of the error along {axis}</source>
      <translation>{axis} 방향 오차의 불확도</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>uncorrected</source>
      <translation>보정 전</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>uniform</source>
      <translation>균등</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>variants</source>
      <translation>변형</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>with effects</source>
      <translation>효과 포함</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>workpiece</source>
      <translation>공작물</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/texts.py" />
      <source>{axis} carriage</source>
      <translation>{axis} 이송체</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>{axis} is in no column; it stood at</source>
      <translation>{axis} 열이 없음. 고정 위치</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_repair.py" />
      <source>{count} can be repaired; values that are there are kept.</source>
      <translation>{count}개를 고칠 수 있으며, 남아 있는 값은 그대로 유지됩니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_repair.py" />
      <source>{count} objects of Sens Workbench in “{name}” are damaged, such as:</source>
      <translation>“{name}”에 있는 Sens Workbench 객체 {count}개가 손상되었습니다. 예:</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_repair.py" />
      <source>{count} only you can settle; each row says how.</source>
      <translation>{count}개는 사용자만 해결할 수 있으며, 각 행에 방법이 있습니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_repair.py" />
      <source>{count} repaired. Undo takes it back.</source>
      <translation>{count}개를 고쳤습니다. 실행 취소로 되돌릴 수 있습니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>{do} (predicted difference {size} µm)</source>
      <translation>{do} (예측 차이 {size} µm)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>{driver}, K from 20 °C</source>
      <translation>{driver}, 20 °C 기준 K</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_motion.py" />
      <source>{error} moves {body} by {value} {unit}, and the tool by {answer} µm. Shown {times} times as large.</source>
      <translation>{error}은(는) {body}을(를) {value} {unit}, 공구를 {answer} µm 움직입니다. {times}배로 보여 줍니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>{faces} faces are cut. Click a face or a row.</source>
      <translation>깎이는 면 {faces}개. 면이나 행을 클릭하십시오.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>{face}: largest error {value} µm at {place}</source>
      <translation>{face}: 최대 오차 {value} µm, 위치 {place}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>{face}: not cut by the path</source>
      <translation>{face}: 경로가 깎지 않음</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>{file}: {rows} readings at {points} places</source>
      <translation>{file}: {points}개 위치의 측정값 {rows}개</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/messages.py" />
      <source>{folder} holds {files} already. Overwrite?</source>
      <translation>{folder}에 이미 {files}이(가) 있습니다. 덮어쓰시겠습니까?</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>{found}. Please answer the questions above.</source>
      <translation>{found}. 위 질문에 답하십시오.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>{level} % of all errors are below &lt;b&gt;{size}&lt;/b&gt;; at the worst place ({place}) {worst}.</source>
      <translation>모든 오차의 {level} %가 &lt;b&gt;{size}&lt;/b&gt;보다 작습니다. 가장 나쁜 위치({place})에서는 {worst}.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>{name} is declared; its share stands in the ranking</source>
      <translation>{name}을(를) 선언했습니다. 몫은 순위에 있습니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>{name} makes {part} % of the variance. rms over the workspace: {rms} µm.</source>
      <translation>{name}이(가) 분산의 {part} %를 만듭니다. 작업 공간의 rms: {rms} µm.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>{name}, lower end</source>
      <translation>{name}, 아래쪽 끝</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>{name}, upper end</source>
      <translation>{name}, 위쪽 끝</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/move_arrows.py" />
      <source>{name}: best place, {length} away</source>
      <translation>{name}: 가장 좋은 위치, {length} 거리</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/residuals.py" />
      <source>{name}: rms {rms} µm</source>
      <translation>{name}: rms {rms} µm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/residuals.py" />
      <source>{name}: rms {rms} µm, largest {largest} µm</source>
      <translation>{name}: rms {rms} µm, 최대 {largest} µm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>{n} blocks leave the travel of the machine.</source>
      <translation>{n}개 블록이 기계의 이동 범위를 벗어납니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>{n} changes would make the plan better.</source>
      <translation>{n}가지 변경으로 계획이 나아집니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>{n} errors read.</source>
      <translation>오차 {n}개를 읽었습니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>{n} machines in {folder}</source>
      <translation>{folder}의 기계 {n}대</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>{n} of them are there already</source>
      <translation>그중 {n}개는 이미 있음</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>{n} records, {refused} refused; an effect stands on {some} machines.</source>
      <translation>기록 {n}개, 거부 {refused}개; 기계 {some}대에서 효과가 인정됩니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/copying.py" />
      <source>{n} rows copied</source>
      <translation>{n}행을 복사했습니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>{n} variants, {best} on the Pareto front (bold), {refused} refused. Files: {folder}</source>
      <translation>변형 {n}개, 파레토 경계 {best}개(굵게), 거부 {refused}개. 파일: {folder}</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>{part} % ± {error} of all errors exceed {limit}: the {level} % error {judged}.</source>
      <translation>모든 오차의 {part} % ± {error}가 {limit}를 넘습니다: {level} % 오차 {judged}.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>{places} places: {rank} of {parameters} parameters are determined.</source>
      <translation>측정 위치 {places}개: 매개변수 {parameters}개 중 {rank}개가 결정됩니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>{rank} of {columns} are determined</source>
      <translation>{columns}개 중 {rank}개 결정됨</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>{rms} µm rms, largest {largest} µm</source>
      <translation>rms {rms} µm, 최대 {largest} µm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>{rows} at {points} places</source>
      <translation>{points}개 위치에서 {rows}개</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>{rows} readings at {points} places</source>
      <translation>{points}개 위치의 측정값 {rows}개</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/residuals.py" />
      <source>{shown} of {all} places</source>
      <translation>{all}개 위치 중 {shown}개</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/trace_pages.py" />
      <source>{symbol} of {body}, driven by {driver}: {size} µm rms over the readings</source>
      <translation>{body}의 {symbol}, 구동 변수 {driver}: 측정값 전체에서 rms {size} µm</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/messages.py" />
      <source>{what} stopped: {error}. Nothing was changed. The report view holds the details.</source>
      <translation>{what}이(가) 중단되었습니다: {error}. 변경된 것은 없습니다. 자세한 내용은 보고서 창에 있습니다.</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/whatif.py" />
      <source>± 5 µm or 10 arcsec</source>
      <translation>± 5 µm 또는 10 arcsec</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>– please answer –</source>
      <translation>– 답을 고르십시오 –</translation>
    </message>
  </context>
  <context>
    <name>Sens_AddEffect</name>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Add Effects</source>
      <translation>효과 추가</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Adds the found effects to the machine, each under its body</source>
      <translation>발견된 효과를 각 부분 아래에 추가합니다</translation>
    </message>
  </context>
  <context>
    <name>Sens_Allocate</name>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Allocate Tolerances…</source>
      <translation>공차 배분…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_allocation.py" />
      <source>Finds the cheapest tolerances that meet a target, and applies them</source>
      <translation>목표를 만족하는 가장 싼 공차를 찾아 적용합니다</translation>
    </message>
  </context>
  <context>
    <name>Sens_Correlated</name>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Correlated Tolerances…</source>
      <translation>상관 공차…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_correlated.py" />
      <source>Declares errors that come from one cause, and shares for a covariance</source>
      <translation>한 원인에서 오는 오차를 선언하고 공분산의 몫을 보여 줍니다</translation>
    </message>
  </context>
  <context>
    <name>Sens_EditMachine</name>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Changes chains, carriages, directions, reference points and travel</source>
      <translation>운동 사슬, 이송체, 방향, 기준점, 이송 범위를 바꿉니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Edit Machine…</source>
      <translation>기계 편집…</translation>
    </message>
  </context>
  <context>
    <name>Sens_EditReadings</name>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>Changes what the columns of an imported table are taken for</source>
      <translation>가져온 표의 열이 무엇을 뜻하는지 바꿉니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>Columns of the Readings…</source>
      <translation>측정값의 열…</translation>
    </message>
  </context>
  <context>
    <name>Sens_Effect</name>
    <message>
      <location filename="../../sensworkbench/gui/task_effect.py" />
      <source>Effect…</source>
      <translation>효과…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_effect.py" />
      <source>Shows what an effect is, and whether it takes part in the errors</source>
      <translation>효과의 내용과 오차에 포함되는지 여부를 표시합니다</translation>
    </message>
  </context>
  <context>
    <name>Sens_ErrorMap</name>
    <message>
      <location filename="../../sensworkbench/gui/analysis.py" />
      <source>Error Map</source>
      <translation>오차 지도</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/analysis.py" />
      <source>Shows the error over the workspace as coloured points or a slice, or hides it</source>
      <translation>작업 공간의 오차를 색 점이나 단면으로 표시하거나 숨깁니다</translation>
    </message>
  </context>
  <context>
    <name>Sens_Example</name>
    <message>
      <location filename="../../sensworkbench/gui/examples.py" />
      <source>Example Machine</source>
      <translation>예제 기계</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/examples.py" />
      <source>Makes an example machine in an empty or new document</source>
      <translation>빈 문서나 새 문서에 예제 기계를 만듭니다</translation>
    </message>
  </context>
  <context>
    <name>Sens_ExampleFXYZ</name>
    <message>
      <location filename="../../sensworkbench/gui/examples.py" />
      <source>Gantry (FXYZ)</source>
      <translation>갠트리 (FXYZ)</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/examples.py" />
      <source>Makes a gantry machine: the tool carries out all three motions</source>
      <translation>갠트리 기계를 만듭니다: 공구가 세 운동을 모두 합니다</translation>
    </message>
  </context>
  <context>
    <name>Sens_ExampleXYFZ</name>
    <message>
      <location filename="../../sensworkbench/gui/examples.py" />
      <source>Makes a machining centre: table on cross slides, spindle on the column</source>
      <translation>머시닝 센터를 만듭니다: 테이블은 십자 이송대 위, 주축은 컬럼에 있습니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/examples.py" />
      <source>Vertical Machining Centre (XYFZ)</source>
      <translation>수직형 머시닝 센터 (XYFZ)</translation>
    </message>
  </context>
  <context>
    <name>Sens_ExampleYFXZ</name>
    <message>
      <location filename="../../sensworkbench/gui/examples.py" />
      <source>Makes a travelling-column machine: the table moves along Y</source>
      <translation>이동 컬럼 기계를 만듭니다: 테이블은 Y 방향으로 움직입니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/examples.py" />
      <source>Travelling Column (YFXZ)</source>
      <translation>이동 컬럼 (YFXZ)</translation>
    </message>
  </context>
  <context>
    <name>Sens_Fit</name>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Fit Declared Errors…</source>
      <translation>선언된 오차 피팅…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Fits the declared errors to the readings: what they explain, and what the plan cannot tell apart</source>
      <translation>선언된 오차를 측정값에 피팅하여 설명되는 것과 구별할 수 없는 것을 보입니다</translation>
    </message>
  </context>
  <context>
    <name>Sens_Fleet</name>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Fleet…</source>
      <translation>기계군…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_fleet.py" />
      <source>Traces the records of many machines: which effect recurs on which machine</source>
      <translation>여러 기계의 측정 기록을 추적합니다: 어느 효과가 어느 기계에서 되풀이되는지</translation>
    </message>
  </context>
  <context>
    <name>Sens_Guide</name>
    <message>
      <location filename="../../sensworkbench/gui/guide.py" />
      <source>Guide</source>
      <translation>안내서</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/guide.py" />
      <source>Shows the guide; in a panel of Sens Workbench F1 shows the section about it</source>
      <translation>안내서(영어)를 표시합니다. Sens Workbench 패널에서 F1을 누르면 해당 절이 표시됩니다</translation>
    </message>
  </context>
  <context>
    <name>Sens_ImportReadings</name>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>Import Readings…</source>
      <translation>측정값 가져오기…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_readings.py" />
      <source>Reads a table of measured errors: laser, ballbar, diagonals, tracker or probe</source>
      <translation>측정 오차 표를 읽습니다: 레이저, 볼바, 대각선, 트래커, 프로브</translation>
    </message>
  </context>
  <context>
    <name>Sens_Jog</name>
    <message>
      <location filename="../../sensworkbench/gui/task_jog.py" />
      <source>Jog…</source>
      <translation>조그…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_jog.py" />
      <source>Moves the axes and all they carry; shows the Abbe offsets as arrows</source>
      <translation>축과 축이 나르는 모든 것을 움직이고 아베 오프셋을 화살표로 보여 줍니다</translation>
    </message>
  </context>
  <context>
    <name>Sens_Limits</name>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>Limits of the Error…</source>
      <translation>오차의 한계…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_limits.py" />
      <source>Says how large the error may become, and how often it exceeds a limit</source>
      <translation>오차가 얼마나 커질 수 있고 얼마나 자주 한계를 넘는지 알려 줍니다</translation>
    </message>
  </context>
  <context>
    <name>Sens_Machine</name>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Machine from Selection…</source>
      <translation>선택에서 기계 만들기…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_machine.py" />
      <source>Makes a machine from parts: which is the bed, and which carries X, Y, Z, spindle and table</source>
      <translation>부품으로 기계를 만듭니다: 베드와 X, Y, Z, 주축, 테이블을 나르는 부품을 지정합니다</translation>
    </message>
  </context>
  <context>
    <name>Sens_MachineFromAssembly</name>
    <message>
      <location filename="../../sensworkbench/gui/task_assembly.py" />
      <source>Machine from Assembly…</source>
      <translation>조립체에서 기계 만들기…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_assembly.py" />
      <source>Makes a machine from an assembly: its sliders are the axes</source>
      <translation>조립체로 기계를 만듭니다. 슬라이더가 축이 됩니다</translation>
    </message>
  </context>
  <context>
    <name>Sens_Motion</name>
    <message>
      <location filename="../../sensworkbench/gui/task_motion.py" />
      <source>Moves the body of an error or effect in the view, exaggerated and animated</source>
      <translation>오차나 효과의 몸체를 화면에서 과장하여 움직입니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_motion.py" />
      <source>Show Motion…</source>
      <translation>움직임 보기…</translation>
    </message>
  </context>
  <context>
    <name>Sens_Moves</name>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>Says what moving a scale, guide block or the tool by a millimetre is worth</source>
      <translation>스케일, 안내 블록, 공구를 1밀리미터 옮길 때의 효과를 알려 줍니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_moves.py" />
      <source>Where to Move…</source>
      <translation>어디로 옮길까…</translation>
    </message>
  </context>
  <context>
    <name>Sens_OriginalColours</name>
    <message>
      <location filename="../../sensworkbench/gui/analysis.py" />
      <source>Gives every part the colours back that it had before, or shows those of the result again</source>
      <translation>모든 부품에 이전 색상을 되돌리거나 결과의 색상을 다시 표시합니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/analysis.py" />
      <source>Original Colours</source>
      <translation>원래 색상</translation>
    </message>
  </context>
  <context>
    <name>Sens_Part</name>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>Shows the part that the tool path of the document makes, and who spoils it</source>
      <translation>문서의 공구 경로가 만드는 공작물과 오차의 원인을 보여 줍니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_part.py" />
      <source>The Part…</source>
      <translation>공작물…</translation>
    </message>
  </context>
  <context>
    <name>Sens_Plan</name>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>Plan Measurement…</source>
      <translation>측정 계획…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_plan.py" />
      <source>Says how well each declared error will be known, before anything is measured</source>
      <translation>측정 전에 선언된 각 오차를 얼마나 정확히 알게 될지 알려 줍니다</translation>
    </message>
  </context>
  <context>
    <name>Sens_Repair</name>
    <message>
      <location filename="../../sensworkbench/gui/task_repair.py" />
      <source>Repair Machine…</source>
      <translation>기계 복구…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_repair.py" />
      <source>Says what is wrong with the objects of a machine and mends what can be mended</source>
      <translation>기계 객체의 이상을 알려 주고 고칠 수 있는 것을 고칩니다</translation>
    </message>
  </context>
  <context>
    <name>Sens_Report</name>
    <message>
      <location filename="../../sensworkbench/gui/export.py" />
      <source>Export Report…</source>
      <translation>보고서 내보내기…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/export.py" />
      <source>Writes the ranking as HTML with a picture of the view, and as JSON and CSV</source>
      <translation>순위를 화면 그림이 있는 HTML과 JSON, CSV로 씁니다</translation>
    </message>
  </context>
  <context>
    <name>Sens_Residuals</name>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Residuals</source>
      <translation>잔차</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Shows the residuals before and after as arrows in the workspace, or hides them</source>
      <translation>전후 잔차를 작업 공간에 화살표로 보이거나 숨깁니다</translation>
    </message>
  </context>
  <context>
    <name>Sens_Review</name>
    <message>
      <location filename="../../sensworkbench/gui/analysis.py" />
      <source>Review</source>
      <translation>검토</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/analysis.py" />
      <source>Shows the ranking, the components and what-if beside the model</source>
      <translation>모델 옆에 순위, 구성요소, 가정 분석을 보여 줍니다</translation>
    </message>
  </context>
  <context>
    <name>Sens_Sensitivity</name>
    <message>
      <location filename="../../sensworkbench/gui/analysis.py" />
      <source>Computes the indices of every error, colours the parts and shows the ranking</source>
      <translation>모든 오차의 지수를 계산하여 부품을 채색하고 순위를 보여 줍니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/analysis.py" />
      <source>Sensitivity</source>
      <translation>민감도</translation>
    </message>
  </context>
  <context>
    <name>Sens_Sweep</name>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Computes the machine in many variants: table, Pareto front, parallel coordinates</source>
      <translation>기계의 여러 변형을 계산합니다: 표, 파레토 경계, 평행 좌표</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_sweep.py" />
      <source>Try Many Designs…</source>
      <translation>여러 설계 시험…</translation>
    </message>
  </context>
  <context>
    <name>Sens_SwitchEffect</name>
    <message>
      <location filename="../../sensworkbench/gui/task_effect.py" />
      <source>Effect On or Off</source>
      <translation>효과 켜기/끄기</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_effect.py" />
      <source>Switches the selected effect off, or on again</source>
      <translation>선택한 효과를 끄거나 다시 켭니다</translation>
    </message>
  </context>
  <context>
    <name>Sens_Tables</name>
    <message>
      <location filename="../../sensworkbench/gui/task_tables.py" />
      <source>Export Compensation Tables…</source>
      <translation>보정 테이블 내보내기…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tables.py" />
      <source>Writes the fitted errors as tables of a controller, and states what they cannot hold</source>
      <translation>맞춘 오차를 제어기 테이블로 쓰고, 담을 수 없는 것을 알려 줍니다</translation>
    </message>
  </context>
  <context>
    <name>Sens_Tolerances</name>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Edits limits and distribution of every error in a table</source>
      <translation>모든 오차의 한계와 분포를 표에서 편집합니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_tolerances.py" />
      <source>Tolerances…</source>
      <translation>공차…</translation>
    </message>
  </context>
  <context>
    <name>Sens_Trace</name>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Searches for the effect that explains what the declared errors leave over</source>
      <translation>선언된 오차가 남긴 것을 설명하는 효과를 찾습니다</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Trace…</source>
      <translation>추적…</translation>
    </message>
  </context>
  <context>
    <name>Sens_TraceReport</name>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Export Trace Report…</source>
      <translation>추적 보고서 내보내기…</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/task_trace.py" />
      <source>Writes what was found as HTML and JSON, with the augmented machine</source>
      <translation>발견한 것을 HTML과 JSON으로, 확장된 기계와 함께 저장합니다</translation>
    </message>
  </context>
  <context>
    <name>Workbench</name>
    <message>
      <location filename="../../sensworkbench/gui/command.py" />
      <source>Sens Analysis</source>
      <translation>Sens 해석</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/command.py" />
      <source>Sens Closed Loop</source>
      <translation>Sens 폐루프</translation>
    </message>
    <message>
      <location filename="../../sensworkbench/gui/command.py" />
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
