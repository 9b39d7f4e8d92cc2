import org.jetbrains.kotlin.gradle.dsl.KotlinJvmProjectExtension

plugins { `java-library` }

// agents with faults, for the tests here and for the benchmarks
configure<KotlinJvmProjectExtension> {
    sourceSets.named("test") { kotlin.srcDir("src/planted/kotlin") }
}
sourceSets.named("test") { resources.srcDir("src/planted/resources") }

dependencies {
    compileOnly(libs.jason) // the user's project brings Jason
    api(project(":argo-arch"))
    implementation(project(":argo-recording"))
    testImplementation(libs.jason)
    testImplementation(libs.mockk)
}
