# Makes Markdown tables of results: lines of workload, blocks, by, unit, value, separated by tabs; the median of
# equal ones counts. Lines "goal, workload, by, unit, limit" come first. With `strict`, the exit status is 1 if a
# ratio is more than twice its goal.
BEGIN { FS = "\t" }

$1 == "goal" { goal[$2, $3, $4] = $5; next }

NF != 5 {
  print "not a result: " $0 > "/dev/stderr"
  exit failed = 3
}

{
  key = $1 SUBSEP $3 SUBSEP $4
  if ($4 == "ns per step") {
    if (!known[$1]++) steps[++step_count] = $1
    if ($3 != "by hand" && !met[$3]++) means[++mean_count] = $3
    blocks[$1] = $2
  } else if (!(key in count)) {
    others[++other_count] = key
  }
  values[key, ++count[key]] = $5 + 0
}

function median(key,    i, j, n, sorted, value) {
  n = count[key]
  for (i = 1; i <= n; ++i) {
    value = values[key, i]
    for (j = i - 1; j > 0 && sorted[j] > value; --j) sorted[j + 1] = sorted[j]
    sorted[j + 1] = value
  }
  return n % 2 ? sorted[(n + 1) / 2] : (sorted[n / 2] + sorted[n / 2 + 1]) / 2
}

function against_goal(value, workload, by, unit,    limit) {
  if (!((workload, by, unit) in goal)) return ""
  limit = goal[workload, by, unit]
  if (unit == "ratio" && value > 2 * limit) too_much = 1
  return sprintf(" (goal %s%s)", limit, value <= limit ? "" : ", missed")
}

function number(value) {
  return sprintf(value < 10 ? "%.2f" : value < 100 ? "%.1f" : "%.0f", value)
}

function print_steps(    i, m, key, hand, line) {
  printf "| workload | blocks | by hand"
  for (m = 1; m <= mean_count; ++m) printf " | %s | ratio | per block", means[m]
  printf " |\n|---|---|---"
  for (m = 1; m <= mean_count; ++m) printf "|---|---|---"
  print "|"
  for (i = 1; i <= step_count; ++i) {
    hand = median(steps[i] SUBSEP "by hand" SUBSEP "ns per step")
    line = sprintf("| %s | %d | %s", steps[i], blocks[steps[i]], number(hand))
    for (m = 1; m <= mean_count; ++m) line = line step_cells(steps[i], means[m], hand)
    print line " |"
  }
}

function step_cells(workload, by, hand,    key, value) {
  key = workload SUBSEP by SUBSEP "ns per step"
  if (!(key in count)) return " | | | "
  value = median(key)
  return sprintf(" | %s | %.2f%s | %s", number(value), value / hand,
                 against_goal(value / hand, workload, by, "ratio"), number(value / blocks[workload]))
}

function print_others(    i, part, value) {
  print "| what | by | median |\n|---|---|---|"
  for (i = 1; i <= other_count; ++i) {
    split(others[i], part, SUBSEP)
    value = median(others[i])
    printf "| %s | %s | %s %s%s |\n", part[1], part[2], number(value), part[3],
           against_goal(value, part[1], part[2], part[3])
  }
}

END {
  if (failed) exit failed
  print "Processor time of a step [ns], its ratio to the loop by hand, and per block:\n"
  print_steps()
  print ""
  print_others()
  exit strict && too_much ? 1 : 0
}
