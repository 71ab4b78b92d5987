#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Wrong input to the real program: each gets exit code 2, three lines on
# standard error (where, what, what is allowed), and nothing is written.
#
# usage: bad_input.sh WAKER_BINARY SOURCE_DIR
set -u

waker=$(realpath "$1")
source=$(realpath "$2")
good=$source/parameters/chapter5/dyke.prm
random=$source/parameters/chapter5/analysis1.prm
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/in"
cd "$work/in" || exit 1
failures=0
cases=0

complain()
{
  echo "FAILED: $1: $2"
  sed 's/^/    /' "$work/err"
  failures=$((failures + 1))
}

# All files below the working folder with their contents.
contents()
{
  find . | sort
  find . -type f -exec cksum {} + | sort
}

# check NAME WHERE WHAT -- ARGUMENTS: WHERE and WHAT are regular expressions
# that the first two lines must match.
check()
{
  name=$1 where=$2 what=$3
  shift 4
  cases=$((cases + 1))
  contents > "$work/before"
  "$waker" "$@" > "$work/out" 2> "$work/err" < /dev/null
  code=$?
  contents > "$work/after"
  [ "$code" -eq 2 ] || complain "$name" "exit code $code instead of 2"
  [ "$(wc -l < "$work/err")" -eq 3 ] || complain "$name" "not three lines"
  sed -n 1p "$work/err" | grep -Eq -e "$where" ||
    complain "$name" "first line does not match '$where'"
  sed -n 2p "$work/err" | grep -Eq -e "$what" ||
    complain "$name" "second line does not match '$what'"
  sed -n 3p "$work/err" | grep -Eq '^allowed: .' ||
    complain "$name" "third line does not say what is allowed"
  cmp -s "$work/before" "$work/after" || complain "$name" "wrote something"
}

# The same with one value of the good case changed: set NAME PATH VALUE WHAT
set_value()
{
  check "$1" "^--set $2\$" "$4" -- run "$good" --set "$2=$3"
}

# The same with the good case edited by sed: edit NAME SCRIPT LINE WHAT
edit()
{
  sed "$2" "$good" > case.prm
  check "$1" "^case.prm$3\$" "$4" -- run case.prm
}

number=':[0-9]+'
clay=Materials/clay

# The command line.
check 'no command' 'command line' 'subcommand' --
check 'no file given' 'command line' 'FILE' -- run
check 'unknown option' 'command line' 'fast' -- run "$good" --fast
check 'both modes' 'command line' 'resume' -- run "$good" --resume --overwrite
check 'unknown format' 'command line' 'yaml' -- parameters --format yaml
check 'no value' '^--set Water$' 'cannot read' -- run "$good" --set Water

# The file.
check 'missing file' '^no.prm$' 'No such file' -- run no.prm
check 'folder' '^\.$' 'is a folder' -- run .
check 'empty input' '^standard input' 'no material' -- run -
edit 'misspelt name' 's/Cell size/Cel size/' "$number" '"Cel size"'
edit 'misspelt section' 's/subsection Grid/subsection Gird/' "$number" '"Gird"'
edit 'duplicate name' '/Cell size/p' "$number" 'twice, first at case.prm:'
edit 'duplicate section' 's/subsection Water/subsection Grid/' "$number" \
  'twice, first at case.prm:'
edit 'end missing' '$d' "$number" 'not closed'
edit 'end too much' '$s/$/\nend/' "$number" 'without a subsection'
edit 'no language' '1s/^/Hello/' "$number" 'Hello'
edit 'material of no name' 's/Material = clay/Material = peat/' "$number" 'peat'

# Values.
set_value 'unknown name' 'Grid/Size' 1 '"Size"'
set_value 'wrong type' 'Grid/Cell size' fine '"fine"'
set_value 'out of range' 'Dimension' 4 '"4"'
set_value 'no choice' 'Water/Side' up '"up"'
set_value 'negative strength' "$clay/Initial strength" -1 '-1 kPa'
set_value 'residual above initial' "$clay/Residual strength" 14 '14 kPa'
set_value 'Poisson' "$clay/Poisson's ratio" 0.5 '0\.5'
set_value 'snap-back' "$clay/Softening modulus" -600 'snap-back'
set_value 'hardening' "$clay/Softening modulus" 50 '50 kPa'
set_value 'time step' 'Time stepping/Time step' 0 'is 0'
set_value 'tolerance' 'Newton/Tolerance' 0 'is 0'
set_value 'water above crest' 'Water/Level' 5.5 'not below the crest at 5 m'
set_value 'water at the crest' 'Water/Level' 5 'not below the crest at 5 m'
set_value 'water below the base' 'Water/Level' -1 'below all soil'
set_value 'no level' 'Water/Level' none 'water stands on the left'
set_value 'level with a comma' 'Water/Level' 4,75 'no number'
set_value 'flooded from the start' 'Water/Rise' 0.5 'flooded'
set_value 'too many numbers' 'Grid/Upper corner' '42, 6, 1' '3 numbers'
edit 'no layer' '/Layers/d; /subsection dyke/,/  end/d' \
  ' \(default of Soil profile/Layers\)' 'no layer'

# Sizes without a limit: refused before anything is allocated.
check 'a wide box' 'dyke.prm:[0-9]+$' 'Grid/Cell size: .* unknowns' -- run "$good" \
  --set 'Grid/Upper corner=1070000000, 6'
set_value 'tiny cells' 'Grid/Cell size' 1e-4 '5\.76e\+10 unknowns'
set_value 'no time step' 'Time stepping/Time step' 1e-300 'steps'
check 'tiny cells of a field' '^--set Random fields/strength/Cell size$' \
  'cells of the field along x' -- campaign "$random" --set \
  'Random fields/strength/Cell size=1e-300, 3'
check 'narrow bins' '^--set Histograms/Width bin$' 'bins' -- \
  campaign "$random" --set 'Histograms/Width bin=1e-9'
check 'many realisations' '^--set Campaign/Realisations$' '2\.15e\+09' -- \
  campaign "$random" --set 'Campaign/Realisations=2147483647'
check 'a load far away' '^--set Point loads/p/From$' \
  '15[0-9.]+ m from the nearest' -- run "$good" --set 'Point loads/Names=p' \
  --set 'Point loads/p/From=155000, 5' --set 'Point loads/p/Force=0, -1'

# Decimal commas, where one number is wanted and where a list has too many;
# what is no formula; what does not repeat.
set_value 'comma: number' 'Grid/Cell size' 0,25 '"0,25"'
set_value 'comma: list' 'Grid/Lower corner' '-6,5, 0' '3 numbers'
set_value 'comma: table' 'Water/Rise' '0: 1,5, 3: 2' 'no pair'
set_value 'comma: polygon' 'Soil profile/dyke/Polygon' '0,5, 0; 30, 0; 15, 5' \
  'corner 1'
set_value 'rise in two parts' 'Water/Rise' '1; 2' '";" has no meaning'
set_value 'chance' 'Water/Rise' '0.1*rand()' 'would not repeat'
long=$(printf '%40000s' 1 | tr ' ' 1)
set_value 'long expression' 'Water/Rise' "$long" '40000 characters'
check 'comma: stress' '^--set Soil profile/dyke/Initial stress$' 'a comma' -- \
  run "$good" --set 'Soil profile/dyke/Initial stress=-1,5; -1; -1; 0' \
  --set 'Gravity/Initial stress=false'
check 'comma: displacement' 'Boundary conditions/base/Displacement$' 'a comma' \
  -- run "$good" --set 'Boundary conditions/base/Displacement=0,1*t; free' \
  --set 'Boundary conditions/base/Type=prescribed'
check 'seed' '^--set Campaign/Seed$' '18446744073709551616' -- \
  campaign "$good" --set Campaign/Seed=18446744073709551616

# Numbers of the command line.
for n in -1 18446744073709551615 99999999999999999999 1.5 1e3 '' x; do
  for option in realisation scenario; do
    check "--$option=$n" 'command line' "--$option" -- \
      run "$good" --$option="$n"
  done
done
check '--realisation -1' 'command line' '--realisation is "-1"' -- \
  run "$good" --realisation -1
for part in -1/2 0/2 3/2 1 1/ / '' 1/99999999999 1.5/2 '1 / 2'; do
  check "--chunk=$part" 'command line' '--chunk' -- \
    campaign "$good" --chunk="$part"
done
for range in -1:2 2:2 3:2 : '' 0:18446744073709551616 0-5; do
  check "--realisations=$range" 'command line' '--realisations' -- \
    campaign "$good" --realisations="$range"
done

# Text that is no text, and too much of it.
printf 'subsection Materials\n  set Names = D\374ne\n' > latin.prm
check 'Latin-1' '^latin.prm:2$' 'D\?ne' -- run latin.prm
check 'Latin-1 folder' '^--set Output/Directory$' 'no plain text' -- \
  run "$good" --set "$(printf 'Output/Directory=D\374ne')"
set_value 'folder with #' 'Output/Directory' 'run#1' 'parameters.prm'
set_value 'folder ends in backslash' 'Output/Directory' 'run\' 'parameters.prm'
yes 'subsection a' | head -n 20000 > deep.prm
check 'deep' '^deep.prm:11$' 'deep' -- run deep.prm
head -c 100000 /dev/zero > zeros.prm
check 'zeros' '^zeros.prm:1$' 'cannot read' -- run zeros.prm

# What only the grid can tell.
polygon='Soil profile/dyke/Polygon'
set_value 'no multiple of cells' 'Grid/Upper corner' '42.1, 6' 'multiple'
set_value 'outside the grid' "$polygon" '0,0; 50,0; 15,5' 'outside'
set_value 'self-crossing' "$polygon" '0,0; 30,0; 5,5; 15,5' 'Polygon'
set_value 'two corners' "$polygon" '0,0; 30,0' 'Polygon'
set_value 'no area' "$polygon" '0,0; 30,0; 15,0' 'Polygon'
check 'a layer thinner than round-off' "^--set $polygon\$" 'too thin' -- \
  run "$good" --set "$polygon=0,0; 1e-12,0; 1e-12,1e-12" --set Water/Side=none
check 'a thin layer beside a thick one' '^--set Soil profile/film/Polygon$' \
  'too thin' -- run "$good" --set 'Soil profile/Layers=dyke, film' \
  --set 'Soil profile/film/Material=clay' \
  --set 'Soil profile/film/Polygon=31,0; 31.000000000001,0; 31,1e-12'
set_value 'points' 'Material points/Points per direction' 0 '"0"'
set_value 'stress with gravity step' 'Soil profile/dyke/Initial stress' \
  '-1; -1; -1; 0' 'gravity step'
check 'stress of three parts' '^--set Soil profile/dyke/Initial stress$' \
  'has 3' -- run "$good" --set 'Soil profile/dyke/Initial stress=1; 2; 3' \
  --set 'Gravity/Initial stress=false'
check 'corners inside rows' '^--set Material points/Placement$' 'inside rows' \
  -- run "$good" --set 'Material points/Placement=rows' \
  --set "$polygon=0,0; 30,0; 30,1.05; 0,1.05" --set Water/Side=none
check 'overlap' '^--set Soil profile/[a-z]+/Polygon$' 'overlap' -- \
  run "$good" --set 'Soil profile/Layers=dyke, berm' \
  --set 'Soil profile/berm/Material=clay' \
  --set 'Soil profile/berm/Polygon=20,0; 35,0; 35,2; 20,2'
check 'validate' '^--set' 'outside' -- \
  run "$good" --validate --set "$polygon=0,0; 50,0; 15,5"
check 'strength reduction' '^--set' 'the lower factor' -- \
  strength-reduction "$good" --set 'Strength reduction/Upper factor=0.1'

# Tractions: traction NAME ENTRY VALUE WHAT [further arguments]
traction()
{
  name=$1 entry=$2 value=$3 what=$4
  shift 4
  check "$name" "^--set Tractions/load/$entry\$" "$what" -- \
    run "$good" --set 'Tractions/Names=load' \
    --set "Tractions/load/$entry=$value" "$@"
}
printf '8 1\n20 1\n15 5\n' > open.txt
printf '8 1\n20 4\n20 1\n8 4\n8 1\n' > crossing.txt
printf '8 1\n15 4\n20 1\n8 1\n' > clockwise.txt
printf '8 1\n50 1\n15 4\n8 1\n' > outside.txt
for shape in open crossing clockwise outside missing; do
  case $shape in
    open) what='is open' ;;
    crossing) what='crosses' ;;
    clockwise) what='wrong side' ;;
    outside) what='outside the grid' ;;
    missing) what='cannot be read' ;;
  esac
  traction "user surface: $shape" 'Surface file' "$shape.txt" "$what" \
    --set 'Tractions/load/Method=user surface'
done
check 'no user surface' 'Tractions/load/Surface file' 'is empty' -- \
  run "$good" --set 'Tractions/Names=load' \
  --set 'Tractions/load/Method=user surface'
traction 'volume with GIMP' 'Method' 'volume' 'linear' # fits MPM only
traction 'volume of a slope' 'Method' 'volume' 'cannot be placed' \
  --set 'Kinematics and mapping/Functions=linear'
traction 'no such method' 'Method' 'surface' '"surface"'
traction 'file for contour' 'Surface file' 'open.txt' 'contour'
traction 'two pressures' 'Value' '1; 2' '2 numbers'
traction 'vector' 'Value' '1' '1 numbers' --set 'Tractions/load/Kind=vector'
traction 'no expression' 'Value' '1 +' 'cannot be read'
traction 'comma' 'Value' '0,25' 'a comma'
traction 'table' 'Level' '0: 1, 0: 2' 'does not come after' \
  --set 'Tractions/load/Kind=hydrostatic'
traction 'level below the surface' 'Level' '-1' 'no part of the surface' \
  --set 'Tractions/load/Kind=hydrostatic'
traction 'nothing there' 'Method' 'contour' 'no part of the surface' \
  --set 'Tractions/load/From=-5, 3' --set 'Tractions/load/To=-4, 4'
traction 'a liquid on soil' 'Follows' 'soil' 'liquid' \
  --set 'Tractions/load/Kind=hydrostatic' --set 'Tractions/load/Level=1'
traction 'nodes on soil' 'Follows' 'soil' '"surface nodes"' \
  --set 'Tractions/load/Method=surface nodes'
traction 'fixed points in space' 'Follows' 'space' 'fixed points' \
  --set 'Tractions/load/Method=fixed points'
traction 'half a box' 'From' '1, 1, 1' '3 numbers' \
  --set 'Tractions/load/To=2, 2'
check 'level without a surface' 'Tractions/load/Level' 'is empty' -- \
  run "$good" --set 'Tractions/Names=load' \
  --set 'Tractions/load/Kind=hydrostatic'
check 'unnamed traction' '^--set Tractions/Names' 'no subsection' -- \
  run "$good" --set 'Tractions/Names=load, wind' \
  --set 'Tractions/load/Value=1'
set_value 'gaps as wide as domains' 'Surface/Minimum gap width' 1 '1'
set_value 'rise' 'Water/Rise' '0: 0, 2' 'no pair'
set_value 'constant from when?' 'Stop rules/Loads constant from' soon 'soon'
check 'loads that are not constant' '^--set Stop rules/Loads constant from' \
  'Water/Rise changes' -- run "$good" --set 'Water/Rise=0.01*t' \
  --set 'Stop rules/Loads constant from=5'
check 'point load nowhere' '^--set Point loads/p/From' 'no point' -- \
  run "$good" --set 'Point loads/Names=p' --set 'Point loads/p/Force=0, 1' \
  --set 'Point loads/p/From=-5, 3' --set 'Point loads/p/To=-4, 4'
check 'point load' '^--set Point loads/p/Force' '1 numbers' -- \
  run "$good" --set 'Point loads/Names=p' --set 'Point loads/p/Force=1' \
  --set 'Point loads/p/From=-5, 3'

# Walls, outflow and inflow: wall ENTRY VALUE WHAT, inflow ENTRY VALUE WHAT.
wall()
{
  check "wall: $1 $2" "^--set Walls/w/$1\$" "$3" -- \
    run "$good" --set 'Walls/Names=w' --set "Walls/w/$1=$2"
}

inflow()
{
  entry=$1 value=$2 what=$3
  shift 3
  check "inflow: $entry $value" "^--set Inflow/i/$entry\$" "$what" -- \
    run "$good" --set 'Inflow/Names=i' --set "Inflow/i/$entry=$value" "$@"
}

wall 'Line' '1, 1' '1 corners'
wall 'Line' '1, 1; 1, x' 'no number'
wall 'Line' '1, 1; 1, 99' 'leaves the grid'
wall 'Displacement' 't' '1 parts'
wall 'Type' 'sticky' 'sticky'
check 'wall: explicit' 'Time stepping/Scheme' 'walls' -- run "$good" \
  --set 'Walls/Names=w' --set 'Walls/w/Line=1, 1; 1, 2' \
  --set 'Time stepping/Scheme=explicit'
set_value 'no such face' 'Outflow/Faces' 'right, front' 'front'
set_value 'closed face' 'Outflow/Faces' 'bottom' 'closed'
inflow 'Velocity' 0 '0'
inflow 'Material' sand 'no material' --set 'Inflow/i/Velocity=1'
inflow 'From' '0, 0.1' '0.1 m' --set 'Inflow/i/Velocity=1' \
  --set 'Inflow/i/Material=clay'
inflow 'Face' bottom 'held' --set 'Inflow/i/Velocity=1' \
  --set 'Inflow/i/Material=clay'

# A table whose first row looks like titles to a careless reader.
for table in '3;0.01\n4;0.001\n' '3,5;0,01\n4;0.001\n' \
  '3,5,0,01\n4,0.001\n' 'x, y\n3;0.01\n'; do
  printf "$table" > levels.csv
  check "levels: $table" '^levels.csv:[12]$' 'not a level and a prob' -- \
    campaign "$random" --set 'Risk/Level distribution=table' \
    --set 'Risk/Level table=levels.csv'
  check "measurements: $table" '^levels.csv:[12]$' '"' -- \
    campaign "$random" --set 'Random fields/strength/Measurements=levels.csv'
done

# The output folder. Root may write anywhere, but not below a file.
touch file
set_value 'below a file' 'Output/Directory' file/output 'file'
set_value 'is a file' 'Output/Directory' file 'file'
set_value 'no folder name' 'Output/Directory' '' 'empty'
check 'nothing to resume' 'dyke.prm:[0-9]+' 'does not exist' -- run "$good" --resume

mkdir full
touch full/letter
set_value 'not empty' 'Output/Directory' full 'full'

short="--set Output/Directory=done"
sed 's/^  set Cell size .*/  set Cell size = 0.5/; s/= 40$/= 0.05/' "$good" |
  "$waker" run - $short --set 'Output/Checkpoint interval=0.01' \
    > "$work/out" 2> "$work/err" ||
  complain 'a good case' 'did not run'
[ -f done/summary.json ] || complain 'a good case' 'left no summary'
"$waker" run "$good" --validate $short > "$work/out" 2> "$work/err" ||
  complain 'validate' 'minds the run in the output folder'
grep -q "not empty" "$work/out" || complain 'validate' 'does not mention the folder'
check 'run before' 'Output/Directory' 'done' -- run "$good" $short
check 'checkpoint of another case' 'Output/Directory' 'another case' -- \
  run "$good" $short --resume

echo "$cases cases, $failures failures"
[ "$failures" -eq 0 ]
