package argo.observing

import jason.asSyntax.Plan
import jason.asSyntax.PlanBody

/** A line of a program, whose file is called as Jason calls it. */
data class SourceLine(val file: String, val line: Int)

/** Returns the place of the trigger of [plan]; null: it was not read from a file. */
fun placeOf(plan: Plan): SourceLine? =
    (plan.trigger.literal.srcInfo ?: plan.srcInfo)?.run { place(srcFile ?: plan.sourceFile, srcLine) }

/** Returns the place of [step] of [plan]; null: there is no step, or it was not read from a file. */
fun placeOf(step: PlanBody?, plan: Plan): SourceLine? =
    (step?.srcInfo ?: step?.bodyTerm?.srcInfo)?.run { place(srcFile ?: plan.sourceFile, srcLine) }

private fun place(file: String?, line: Int) = file?.takeIf { line > 0 }?.let { SourceLine(it, line) }
