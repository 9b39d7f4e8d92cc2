package argo.observing

import jason.asSyntax.Plan
import jason.asSyntax.PlanBody

/** A line of a program. [file] is Jason's name for the file. */
data class SourceLine(val file: String, val line: Int)

/** Returns the line of the trigger of [plan]; null if the plan was not read from a file. */
fun placeOf(plan: Plan): SourceLine? =
    (plan.trigger.literal.srcInfo ?: plan.srcInfo)?.run { place(srcFile ?: plan.sourceFile, srcLine) }

/** Returns the line of [step] of [plan]; null if [step] is null, or was not read from a file. */
fun placeOf(step: PlanBody?, plan: Plan): SourceLine? =
    (step?.srcInfo ?: step?.bodyTerm?.srcInfo)?.run { place(srcFile ?: plan.sourceFile, srcLine) }

private fun place(file: String?, line: Int) = file?.takeIf { line > 0 }?.let { SourceLine(it, line) }
