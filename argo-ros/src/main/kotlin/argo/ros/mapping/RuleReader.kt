package argo.ros.mapping

import argo.ros.mapping.CommandRule.Kind
import java.util.concurrent.TimeUnit

private val TOPIC = Regex("[~/A-Za-z][A-Za-z0-9_/~]*")
private val TYPE = Regex("[A-Za-z][A-Za-z0-9_]*(/[A-Za-z][A-Za-z0-9_]*){1,2}")
private val VARIABLE = Regex("[A-Z][A-Za-z0-9_]*")
private val FRAME = Regex("[A-Za-z0-9_/][A-Za-z0-9_/.]*(-(?!>)[A-Za-z0-9_/.]*)*")
private const val TYPE_IN_WORDS = "a type, as sensor_msgs/Range or sensor_msgs/msg/Range"
private const val MAX_MS = 86_400_000.0

internal fun perceptRuleOf(text: String, start: Place): PerceptRule {
    val cursor = Cursor(text, start)
    val frames = if (cursor.take("tf ")) framesIn(cursor) else null
    val topic = frames?.run { "tf $parent $child" } ?: cursor.expect(TOPIC, "the name of a topic, as /sonar/front")
    val type = if (frames == null) cursor.expect(TYPE, TYPE_IN_WORDS) else Frames.TYPE
    val usual = if (frames == null) UsualType.of(type) else UsualType.FRAME_POSE
    val shown = if (frames == null) type else "the pose of a frame"
    val reader = ExpressionReader(cursor) { name, place -> argumentOf(name, place, shown, usual) }
    val percept = when {
        cursor.take("->") -> reader.readLiteral()
        frames == null -> shortForm(topic, type, usual, cursor)
        else -> throw cursor.refusal("expected '->' and a literal, as -> pose(x, y, yaw), but found ${cursor.found}")
    }
    val condition = if (cursor.take("if")) reader.readCondition() else null
    val forMs = if (cursor.take("for")) duration(cursor) else null
    val allPlace = cursor.place
    val isOfEach = cursor.take("all")
    if (isOfEach && frames != null) throw Refusal(allPlace, "the pose of a frame is no event; each message of /tf tells many frames")
    if (isOfEach && forMs != null) throw Refusal(allPlace, "a percept of all messages is an event, and does not last for a time")
    end(cursor, "-> LITERAL, then if CONDITION, then for TIME or all")
    val rule = PerceptRule(start, topic, type, percept, condition, forMs, isOfEach, frames)
    if (usual != null) rule.fields().forEach { checkField(it, shown, usual.fields) }
    if (usual != null) checkAtoms(rule, reader, shown, usual.fields)
    return rule
}

internal fun PerceptRule.fields(): List<Expression.Field> =
    percept.fields() + condition?.fields().orEmpty()

private fun framesIn(cursor: Cursor): Frames {
    val (parent, child) = List(2) { cursor.expect(FRAME, "two frames, as tf map base_link -> pose(x, y, yaw)").removePrefix("/") }
    return Frames(parent, child)
}

/**
 * Returns the percept of a message as a [Value.Symbol]. Returns [Value.None] if a value is missing, and [NO_PERCEPT] if the condition does
 * not hold.
 */
internal fun PerceptRule.perceptIn(scope: Scope): Value = when (val truth = condition?.truthIn(scope) ?: Value.TRUE) {
    Value.TRUE -> percept.valueIn(scope)
    is Value.None -> truth
    else -> NO_PERCEPT
}

private val NO_PERCEPT = Value.Text("")

/**
 * Refuses names that probably mean fields. Refuses unquoted atoms behind the first field, and functors with the name of a field. `f` in
 * `dist(f, range)` is accepted.
 */
private fun checkAtoms(rule: PerceptRule, reader: ExpressionReader, type: String, known: Set<String>) {
    val fields = known.joinToString(", ")
    rule.percept.literals().find { it.functor in known }?.let { throw Refusal(checkNotNull(it.place), meantAsField(it.functor, type)) }
    val first = rule.percept.arguments.indexOfFirst { it.fields().isNotEmpty() }
    val suspects = rule.percept.arguments.drop(maxOf(0, first)).takeIf { first >= 0 || rule.condition == null }.orEmpty()
    val (atom, at) = suspects.firstNotNullOfOrNull { one -> reader.atoms.find { it.first === one } } ?: return
    val name = (atom as Expression.Constant).value.plainText()
    throw Refusal(at, "$name is no field of $type, which has $fields; an atom here would be written '$name'")
}

/** Returns the error message for an unquoted literal whose functor [name] is a field of [type]. */
internal fun meantAsField(name: String, type: String) =
    "$name is a field of $type, and no literal; an item of a list is $name[0], and a literal would be written '$name'(…)"

private fun checkField(field: Expression.Field, type: String, known: Set<String>) {
    val name = (field.path.first() as Step.Name).name
    if (name in known || constantIn(field.path) != null) return
    throw Refusal(field.place, "$type has no field $name; it has ${known.joinToString(", ")}; an atom would be written '$name'")
}

private fun argumentOf(name: String, place: Place, type: String, usual: UsualType?): Expression {
    val field = Expression.Field(place, listOf(Step.Name(name)))
    if (usual == null || name in usual.fields || constantIn(field.path) != null) return field
    val meant = usual.fields.find { isNear(name, it) }
    if (meant != null) throw Refusal(place, "$type has no field $name; is $meant meant? An atom $name would be written '$name'")
    if (!name[0].isLowerCase()) throw Refusal(place, "$type has no field $name, and it is no atom")
    if (Function.of(name) != null) throw Refusal(place, "$name is a function, as $name(FIELD), and no field of $type")
    return Expression.Constant(Value.Symbol(name))
}

private fun shortForm(topic: String, type: String, usual: UsualType?, cursor: Cursor): Expression.Compound {
    val name = topic.substringAfterLast('/')
    val arguments = usual?.percept?.joinToString(", ", "(", ")").orEmpty()
    val percept = try {
        ExpressionReader(Cursor("$name$arguments", cursor.place)).readLiteral()
    } catch (_: Refusal) {
        throw cursor.refusal("'$name' is no name for a percept; write one behind '->', as -> dist${arguments.ifEmpty { "(FIELD)" }}")
    }
    return if (usual != null) percept else percept.copy(arguments = listOf(Expression.AllFields))
}

private fun duration(cursor: Cursor): Int {
    val place = cursor.place
    val number = cursor.expect(ExpressionReader.NUMBER, "a time, as 500 ms or 2 s").toDouble()
    val unit = if (cursor.take("ms")) 1.0 else if (cursor.take("s")) TimeUnit.SECONDS.toMillis(1).toDouble() else null
    if (unit == null) throw cursor.refusal("expected ms or s, but found ${cursor.found}")
    return (number * unit).takeIf { it in 1.0..MAX_MS }?.toInt() ?: throw Refusal(place, "a time is 1 ms to 24 hours")
}

private fun end(cursor: Cursor, expected: String) {
    if (cursor.isAtEnd) return
    val hint = if (cursor.take("=")) "; values are compared by ==" else ""
    throw cursor.refusal("expected $expected, but found ${cursor.found}$hint")
}

internal fun commandRuleOf(text: String, start: Place): CommandRule {
    val cursor = Cursor(text, start)
    val literal = ExpressionReader(cursor).readLiteral()
    val parameters = literal.arguments.map { parameterOf(it, start) }
    parameters.groupBy { it }.values.find { it.size > 1 }?.let { throw Refusal(start, "${it[0]} is two arguments of ${literal.functor}") }
    cursor.expect("->", "behind the command")
    val kind = when (cursor.takeOneOf(listOf("topic", "service", "action"))) {
        "service" -> Kind.SERVICE
        "action" -> Kind.ACTION
        else -> Kind.TOPIC
    }
    val target = cursor.expect(TOPIC, "the name of a topic, service or action, as /cmd_vel")
    val typePlace = cursor.place
    val type = cursor.expect(TYPE, TYPE_IN_WORDS)
    if (kind == Kind.ACTION && !isAction(type)) {
        throw Refusal(typePlace, "$type is no action: ROS 1 has pkg/DockAction, ROS 2 pkg/action/Dock")
    }
    val hasFields = cursor.take("(")
    val fields = if (hasFields) fieldValues(cursor, parameters) else shortFields(cursor, literal.functor, parameters, kind, type)
    val used = fields.flatMap { it.value.fields() }.map { written(it.path) }
    parameters.find { it !in used }?.let {
        throw Refusal(start, "the argument $it of ${literal.functor} is used nowhere; write FIELD = $it")
    }
    val withinMs = if (cursor.take("within")) duration(cursor) else kind.defaultMs.toInt()
    val inResponse = ExpressionReader(cursor)
    val feedbackPlace = cursor.place
    val owner = "$target for ${literal.functor}/${parameters.size}"
    val feedback = if (cursor.take("feedback")) feedbackOf(inResponse.readLiteral(), kind, owner, type, feedbackPlace) else null
    val answerPlace = cursor.place
    val answer = if (cursor.take("answer")) inResponse.read(isArgument = true) else null
    if (answer != null && kind == Kind.TOPIC) throw Refusal(answerPlace, "nobody answers a message of a topic; services and actions answer")
    end(cursor, "within TIME, then feedback LITERAL, then answer VALUE")
    return CommandRule(start, literal.functor, parameters, kind, target, type, fields, hasFields, withinMs, answer, feedback)
}

private fun feedbackOf(percept: Expression.Compound, kind: Kind, owner: String, type: String, place: Place): PerceptRule {
    if (kind != Kind.ACTION) throw Refusal(place, "only actions have feedback")
    val feedbackType = if (isRos2Action(type)) type else type.removeSuffix("Action") + "Feedback"
    return PerceptRule(place, "the feedback of $owner", feedbackType, percept, null, null)
}

internal fun isRos2Action(type: String) = "/action/" in type

private fun isAction(type: String) = isRos2Action(type) || type.endsWith("Action")

private fun parameterOf(argument: Expression, start: Place): String {
    val field = argument as? Expression.Field ?: throw Refusal(start, "the arguments of a command are variables, as move(V, W)")
    return written(field.path).takeIf(VARIABLE::matches)
        ?: throw Refusal(field.place, "${written(field.path)} is no variable; one begins with a capital letter")
}

private fun fieldValues(cursor: Cursor, parameters: List<String>): List<FieldValue> {
    val fields = ArrayList<FieldValue>()
    if (cursor.take(")")) return fields
    val reader = ExpressionReader(cursor)
    do {
        val place = cursor.place
        val path = ArrayList<String>()
        do path += cursor.expect(ExpressionReader.NAME, "a field, as linear.x = V") while (cursor.take("."))
        cursor.expect("=", "behind ${path.joinToString(".")}")
        val value = reader.read()
        value.fields().forEach { checkParameter(it, parameters) }
        value.literals().firstOrNull()?.let {
            throw Refusal(checkNotNull(it.place), "${it.functor} is no function; a literal would be written '${it.functor}'(…)")
        }
        fields.find { startsWith(path, it.path) || startsWith(it.path, path) }?.let {
            val (given, before) = path.joinToString(".") to it.path.joinToString(".")
            throw Refusal(place, if (given == before) "$given is given a value twice" else "$given has a value already, by $before")
        }
        fields += FieldValue(place, path, value)
    } while (cursor.take(","))
    cursor.expect(")", "behind the fields")
    return fields
}

private fun startsWith(path: List<String>, begin: List<String>) = path.take(begin.size) == begin

private fun checkParameter(field: Expression.Field, parameters: List<String>) {
    val name = written(field.path)
    if (name in parameters) return
    val known = if (parameters.isEmpty()) "it has none" else "it has ${parameters.joinToString(", ")}"
    throw Refusal(field.place, "$name is no argument of the command; $known. An atom is written in quotes, '$name'")
}

private fun shortFields(cursor: Cursor, functor: String, parameters: List<String>, kind: Kind, type: String): List<FieldValue> {
    if (parameters.isEmpty()) return emptyList()
    val fields = UsualType.of(type)?.command?.takeIf { kind == Kind.TOPIC && it.size == parameters.size } ?: throw cursor.refusal(
        "expected the fields that the arguments of $functor are for, as $type(field = ${parameters[0]}), but found ${cursor.found}",
    )
    return parameters.zip(fields) { parameter, field ->
        FieldValue(cursor.place, field.split('.'), Expression.Field(cursor.place, listOf(Step.Name(parameter))))
    }
}
