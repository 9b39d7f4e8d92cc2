package argo.ros.mapping

import kotlinx.serialization.json.JsonArray

/** The functions of mappings. [of] returns the function's value, or null if it does not accept the arguments. */
internal enum class Function(val taken: String, val of: (List<Value>) -> Value?) {
    ROUND(A_NUMBER, ofNumber(Math::rint)),
    FLOOR(A_NUMBER, ofNumber(Math::floor)),
    CEIL(A_NUMBER, ofNumber(Math::ceil)),
    ABS(A_NUMBER, ofNumber(Math::abs)),
    SQRT(A_NUMBER, ofNumber(Math::sqrt)),
    SIN(A_NUMBER, ofNumber(Math::sin)),
    COS(A_NUMBER, ofNumber(Math::cos)),

    DEG(A_NUMBER, ofNumber(Math::toDegrees)),
    MIN(NUMBERS, ofNumbers { it.minOrNull() }),
    MAX(NUMBERS, ofNumbers { it.maxOrNull() }),
    SUM(NUMBERS, ofNumbers { numbers -> numbers.sum().takeIf { numbers.isNotEmpty() } }),
    MEAN(NUMBERS, ofNumbers { numbers -> numbers.average().takeIf { numbers.isNotEmpty() } }),

    /** The number of items in a list, including items that were not measured. */
    LEN("a list", { arguments -> arguments.singleOrNull()?.list()?.let { Value.of(it.size.toDouble()) } }),

    /** The heading of a quaternion in rad, counter-clockwise from the x axis. */
    YAW("a quaternion with the numbers x, y, z and w", { arguments -> arguments.singleOrNull()?.let(::yawOf) });

    val written = name.lowercase()
    val takesSeveral get() = taken == NUMBERS

    companion object {
        fun of(name: String): Function? = entries.find { it.written == name }

        /** Names of functions in other languages, each with ARGO's function, or null if ARGO has none. */
        val FOREIGN: Map<String, Function?> = mapOf(
            "count" to LEN, "length" to LEN, "size" to LEN, "average" to MEAN, "avg" to MEAN, "minimum" to MIN, "maximum" to MAX,
            "degrees" to DEG, "int" to FLOOR, "tan" to null, "atan" to null, "atan2" to null, "pow" to null, "rad" to null,
            "radians" to null, "median" to null,
        )

        /** Returns the function that the unknown [name] probably means, or null if [name] may be a literal. */
        fun meant(name: String): Function? =
            FOREIGN[name] ?: entries.find { it.written.length >= SHORTEST_SLIP && isNear(name, it.written) }
    }
}

private const val A_NUMBER = "a number"
private const val NUMBERS = "a list with numbers, or several numbers"

/** Shorter function names have no tolerance for typing errors: `pos` need not mean `cos`. */
private const val SHORTEST_SLIP = 4

private fun ofNumber(work: (Double) -> Double): (List<Value>) -> Value? = { it.singleOrNull()?.number()?.let(work)?.let(Value::of) }

/** Skips items of a list that were not measured. */
private fun ofNumbers(work: (List<Double>) -> Double?): (List<Value>) -> Value? = { arguments ->
    val numbers =
        if (arguments.size == 1) arguments[0].list()?.mapNotNull { Value.of(it).number() }
        else arguments.map { it.number() }.takeIf { null !in it }?.filterNotNull()
    numbers?.let(work)?.let(Value::of)
}

private fun Value.list() = (this as? Value.Part)?.json as? JsonArray

private fun yawOf(quaternion: Value): Value? {
    val scope = (quaternion as? Value.Part)?.json?.let(::MessageScope) ?: return null
    val (x, y, z, w) = listOf("x", "y", "z", "w").map { scope.valueOf(listOf(Step.Name(it))).number() ?: return null }
    return Value.of(headingOf(x, y, z, w))
}

/** Returns the heading of a unit quaternion in rad, counter-clockwise from the x axis. */
internal fun headingOf(x: Double, y: Double, z: Double, w: Double): Double = Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))

/** Returns true if [one] differs from [other] by one wrong, missing or extra letter, or by two swapped letters. */
internal fun isNear(one: String, other: String): Boolean {
    if (other.length <= 2 || Math.abs(one.length - other.length) > 1) return false
    val same = one.commonPrefixWith(other).length
    val end = one.drop(same).commonSuffixWith(other.drop(same)).length
    val (a, b) = one.substring(same, one.length - end) to other.substring(same, other.length - end)
    return a.length <= 1 && b.length <= 1 || a == b.reversed() && a.length == 2
}
