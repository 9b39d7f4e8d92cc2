package argo.tools.replay

import argo.tools.command.nanosOf
import picocli.CommandLine.ITypeConverter
import picocli.CommandLine.TypeConversionException

/** A time in a recording: seconds after the first cycle, or a cycle of an agent. */
internal sealed interface Moment {
    class Time(val ns: Long) : Moment

    class OfCycle(val number: Int) : Moment

    /** Reads `12.3`, `12.3s` and `c412`. */
    class Converter : ITypeConverter<Moment> {
        override fun convert(text: String): Moment {
            val cycle = if (text.startsWith('c')) text.drop(1).toIntOrNull() else null
            val seconds = text.removeSuffix("s").toBigDecimalOrNull()?.let(::nanosOf)
            return cycle?.takeIf { it >= 0 }?.let(::OfCycle) ?: seconds?.let(::Time)
                ?: throw TypeConversionException("$text is no moment of a recording; 12.3 is a second, and c412 a cycle")
        }
    }
}
